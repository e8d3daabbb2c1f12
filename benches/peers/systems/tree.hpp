// A tree of bodies, as `models.py` writes it: the size, then gravity, then a line for each joint with
// kind, carrier (0 is the ground), axis, the rotation and the place of its frame in that of its carrier,
// mass, center and the tensor about it, in the axes of the joint.
#pragma once

#include <fstream>
#include <stdexcept>
#include <string>

#include <pinocchio/multibody.hpp>

inline pinocchio::Model tree(const std::string & path)
{
  using Eigen::Matrix3d;
  using Eigen::Vector3d;
  std::ifstream file(path);
  pinocchio::Model model;
  int joints;
  file >> joints;
  Vector3d gravity;
  const auto vector = [&](Vector3d & v) { file >> v[0] >> v[1] >> v[2]; };
  vector(gravity);
  model.gravity.linear() = gravity;
  for (int k = 1; k <= joints; ++k)
  {
    std::string kind;
    std::size_t carrier;
    Vector3d axis, place, center;
    Matrix3d rotation, tensor;
    double mass;
    file >> kind >> carrier;
    vector(axis);
    for (int i = 0; i < 9; ++i)
      file >> rotation(i / 3, i % 3);
    vector(place);
    file >> mass;
    vector(center);
    for (int i = 0; i < 9; ++i)
      file >> tensor(i / 3, i % 3);
    pinocchio::JointModel joint;
    if (kind == "free")
      joint = pinocchio::JointModelFreeFlyer();
    else if (kind == "ball")
      joint = pinocchio::JointModelSpherical();
    else if (axis == Vector3d::UnitX())
      joint = pinocchio::JointModelRX();
    else if (axis == Vector3d::UnitY())
      joint = pinocchio::JointModelRY();
    else if (axis == Vector3d::UnitZ())
      joint = pinocchio::JointModelRZ();
    else
      joint = pinocchio::JointModelRevoluteUnaligned(axis);
    const pinocchio::SE3 frame(rotation, place);
    const auto id = model.addJoint(carrier, joint, frame, "joint_" + std::to_string(k));
    model.appendBodyToJoint(id, pinocchio::Inertia(mass, center, tensor), pinocchio::SE3::Identity());
  }
  if (!file)
    throw std::runtime_error("not a tree: " + path);
  return model;
}
