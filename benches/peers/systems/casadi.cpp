// Writes C by CasADi, from Pinocchio's articulated-body algorithm over its symbols: casadi TREE NAME, in the folder where it is run.
// Of the two forms that Pinocchio has, in axes of the world or of each body, that of fewer instructions.
#include <pinocchio/autodiff/casadi.hpp>

#include <pinocchio/algorithm/aba.hpp>

#include <iostream>

#include "tree.hpp"

using casadi::SX;

casadi::Function aba(const pinocchio::Model & model, const std::string & name, pinocchio::Convention convention)
{
  typedef pinocchio::ModelTpl<SX> Model;
  typedef Eigen::Matrix<SX, Eigen::Dynamic, 1> Vector;
  const Model symbolic = model.cast<SX>();
  pinocchio::DataTpl<SX> data(symbolic);
  const SX q = SX::sym("q", model.nq), v = SX::sym("v", model.nv), drives = SX::sym("drives", model.nv);
  const auto listed = [](const SX & column) {
    Vector list(column.size1());
    for (int k = 0; k < list.size(); ++k)
      list[k] = column(k);
    return list;
  };
  const Vector found = pinocchio::aba(symbolic, data, listed(q), listed(v), listed(drives), convention);
  SX accelerations(model.nv, 1);
  for (int k = 0; k < model.nv; ++k)
    accelerations(k) = found[k];
  // a sum of no terms would be a sparse zero
  return casadi::Function(name, std::vector<SX>{q, v, drives}, std::vector<SX>{cse(densify(accelerations))});
}

int main(int, char ** words)
{
  const pinocchio::Model model = tree(words[1]);
  const std::string name = words[2];
  const auto world = aba(model, name, pinocchio::Convention::WORLD);
  const auto local = aba(model, name, pinocchio::Convention::LOCAL);
  std::cout << name << ": " << world.n_instructions() << " instructions in axes of the world, " << local.n_instructions() << " in those of the bodies\n";
  casadi::CodeGenerator generator(name + ".c");
  generator.add(world.n_instructions() < local.n_instructions() ? world : local);
  generator.generate();
}
