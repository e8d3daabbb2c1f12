// What CasADi wrote in a loop, timed: compiled with -DNAME=.. and linked with NAME.c
#include <time.h>

int NAME(const double ** arguments, double ** results, long long * integers, double * work, int memory);

double run(int nq, int nv, int states, const double * q, const double * v, const double * drives, double * found, int rounds)
{
  struct timespec start, end;
  clock_gettime(CLOCK_MONOTONIC, &start);
  for (int round = 0; round < rounds; ++round)
    for (int k = 0; k < states; ++k)
    {
      const double * arguments[] = {q + k * nq, v + k * nv, drives + k * nv};
      double * results[] = {found + k * nv};
      NAME(arguments, results, 0, 0, 0);
    }
  clock_gettime(CLOCK_MONOTONIC, &end);
  return (end.tv_sec - start.tv_sec) * 1e9 + (end.tv_nsec - start.tv_nsec);
}
