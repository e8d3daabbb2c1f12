// Pinocchio's articulated-body algorithm in a loop, timed: its header alone, compiled for this processor.
#include <pinocchio/algorithm/aba.hpp>

#include <chrono>

#include "tree.hpp"

struct Body
{
  pinocchio::Model model;
  pinocchio::Data data;
  explicit Body(const char * path) : model(tree(path)), data(model) {}
};

extern "C" void * make(const char * path)
{
  return new Body(path);
}

// The ns of as many rounds over all states; in axes of the world, or of each body.
extern "C" double run(void * made, int in_world, int states, const double * q, const double * v, const double * drives, double * found, int rounds)
{
  auto & [model, data] = *static_cast<Body *>(made);
  const auto convention = in_world ? pinocchio::Convention::WORLD : pinocchio::Convention::LOCAL;
  typedef Eigen::Map<const Eigen::VectorXd> Numbers;
  const auto start = std::chrono::steady_clock::now();
  for (int round = 0; round < rounds; ++round)
    for (int k = 0; k < states; ++k)
    {
      const Numbers position(q + k * model.nq, model.nq), rate(v + k * model.nv, model.nv), drive(drives + k * model.nv, model.nv);
      Eigen::Map<Eigen::VectorXd>(found + k * model.nv, model.nv) = pinocchio::aba(model, data, position, rate, drive, convention);
    }
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
}
