// MuJoCo's mj_forward in a loop, timed; its numbers are copied in and out.
#include <string.h>
#include <time.h>

#include <mujoco/mujoco.h>

typedef struct
{
  mjModel * model;
  mjData * data;
} Body;

static Body bodies[64];
static int made;

void * make(const char * path)
{
  char error[1000];
  Body * body = &bodies[made++];
  body->model = mj_loadXML(path, 0, error, sizeof error);
  body->data = mj_makeData(body->model);
  return body;
}

double run(void * of, int states, const double * q, const double * v, const double * drives, double * found, int rounds)
{
  const mjModel * model = ((Body *)of)->model;
  mjData * data = ((Body *)of)->data;
  const int nq = model->nq, nv = model->nv;
  struct timespec start, end;
  clock_gettime(CLOCK_MONOTONIC, &start);
  for (int round = 0; round < rounds; ++round)
    for (int k = 0; k < states; ++k)
    {
      memcpy(data->qpos, q + k * nq, nq * sizeof *q);
      memcpy(data->qvel, v + k * nv, nv * sizeof *q);
      memcpy(data->qfrc_applied, drives + k * nv, nv * sizeof *q);
      mj_forward(model, data);
      memcpy(found + k * nv, data->qacc, nv * sizeof *q);
    }
  clock_gettime(CLOCK_MONOTONIC, &end);
  return (end.tv_sec - start.tv_sec) * 1e9 + (end.tv_nsec - start.tv_nsec);
}
