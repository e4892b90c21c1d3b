// Elastic bodies beside SUNDIALS' CVODE: an integrator that shares nothing with them but the equation.
//
// Backward difference formulas up to order 2, which are A-stable; higher ones are not, and with springs of 1e12 their
// steps shrink until nothing moves on.
#include <cvode/cvode.h>
#include <gtest/gtest.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <cmath>
#include <vector>

#include "anim/modal_body.hpp"
#include "anim/stepped_body.hpp"
#include "tests/anim/chain_reference.hpp"

namespace morphcl {
namespace {

constexpr int frames = 24;

struct Problem {
  SpringNet net;
  double start = 0, from = 0, slope = 0;  // of the common factor of all driven places, in this frame
};

double share_of(std::size_t mass) { return 1 + static_cast<double>(mass) / 8; }

int derivative(sunrealtype t, N_Vector y, N_Vector out, void* user) {
  const Problem& p = *static_cast<const Problem*>(user);
  const std::size_t n = p.net.masses;
  const double *x = N_VGetArrayPointer(y), *v = x + n;
  double *dx = N_VGetArrayPointer(out), *dv = dx + n;
  const double driven = p.from + p.slope * (t - p.start), beta = p.net.stiffness_damping;
  for (std::size_t i = 0; i < n; ++i) {
    dx[i] = v[i];
    dv[i] = p.net.anchor * (driven * share_of(i) - x[i] - beta * v[i]) - p.net.damping * v[i];
  }
  for (const SpringNet::Edge& edge : p.net.edges) {
    const double force = edge.stiffness * ((x[edge.a] - x[edge.b]) + beta * (v[edge.a] - v[edge.b]));
    dv[edge.a] -= force;
    dv[edge.b] += force;
  }
  return 0;
}

int jacobian(sunrealtype, N_Vector, N_Vector, SUNMatrix m, void* user, N_Vector, N_Vector, N_Vector) {
  const Problem& p = *static_cast<const Problem*>(user);
  const auto n = static_cast<sunindextype>(p.net.masses);
  SUNMatZero(m);
  const auto add = [&](sunindextype row, sunindextype column, double k) {
    SM_ELEMENT_D(m, n + row, column) -= k;
    SM_ELEMENT_D(m, n + row, n + column) -= p.net.stiffness_damping * k;
  };
  for (sunindextype i = 0; i < n; ++i) {
    SM_ELEMENT_D(m, i, n + i) = 1;
    add(i, i, p.net.anchor);
    SM_ELEMENT_D(m, n + i, n + i) -= p.net.damping;
  }
  for (const SpringNet::Edge& edge : p.net.edges) {
    add(edge.a, edge.a, edge.stiffness);
    add(edge.b, edge.b, edge.stiffness);
    add(edge.a, edge.b, -edge.stiffness);
    add(edge.b, edge.a, -edge.stiffness);
  }
  return 0;
}

// Positions at frames 0 to 24. Every frame starts anew, for the driven places turn there.
std::vector<std::vector<double>> integrate(Problem problem, const Track& weight, double tolerance) {
  const std::size_t n = problem.net.masses;
  SUNContext context = nullptr;
#ifdef SUN_COMM_NULL
  SUNContext_Create(SUN_COMM_NULL, &context);
#else  // before SUNDIALS 7
  SUNContext_Create(nullptr, &context);
#endif
  const auto size = static_cast<sunindextype>(2 * n);
  N_Vector y = N_VNew_Serial(size, context);
  N_VConst(0, y);
  SUNMatrix matrix = SUNDenseMatrix(size, size, context);
  SUNLinearSolver solver = SUNLinSol_Dense(y, matrix, context);
  void* cvode = CVodeCreate(CV_BDF, context);
  CVodeSetUserData(cvode, &problem);
  CVodeInit(cvode, derivative, 0, y);
  CVodeSStolerances(cvode, tolerance, tolerance);
  CVodeSetMaxOrd(cvode, 2);
  CVodeSetMaxNumSteps(cvode, 1'000'000);
  CVodeSetLinearSolver(cvode, solver, matrix);
  CVodeSetJacFn(cvode, jacobian);
  std::vector<std::vector<double>> motion = {std::vector<double>(n, 0.0)};
  for (int k = 0; k < frames; ++k) {
    problem.start = k / 24.0;
    problem.from = *weight.key_value(static_cast<std::size_t>(k));
    problem.slope = 24 * (*weight.key_value(static_cast<std::size_t>(k) + 1) - problem.from);
    const double end = (k + 1) / 24.0;
    CVodeReInit(cvode, problem.start, y);
    CVodeSetStopTime(cvode, end);
    sunrealtype reached = problem.start;
    EXPECT_GE(CVode(cvode, end, y, &reached, CV_NORMAL), 0) << "frame " << k;
    motion.emplace_back(N_VGetArrayPointer(y), N_VGetArrayPointer(y) + n);
  }
  CVodeFree(&cvode);
  SUNLinSolFree(solver);
  SUNMatDestroy(matrix);
  N_VDestroy(y);
  SUNContext_Free(&context);
  return motion;
}

TEST(ElasticBody, MovesAsCvodeSays) {
  const MorphDrive drive = reference::chain_drive(8, frames);
  const SpringNet net = reference::stiff_chain(8);
  constexpr double tolerance = 1e-7;
  const std::vector<std::vector<double>> motion = integrate({net}, drive.weights.tracks[0].track, tolerance);
  ModalBody modal(net, EdgeRest::base, drive, reference::chain_time);
  SteppedBody stepped(net, EdgeRest::base, drive, reference::chain_time);
  Displacements exact, x;
  double worst = 0;
  for (int k = 0; k <= frames; ++k) {
    modal.displacements_at(k, exact);
    stepped.displacements_at(k, x);
    for (std::size_t i = 0; i < 8; ++i) {
      const double theirs = motion[static_cast<std::size_t>(k)][i];
      worst = std::max(worst, std::abs(theirs - exact[i].x));
      // Errors of steps add up: some 1,000 of them a second, each within the tolerance.
      EXPECT_NEAR(theirs, exact[i].x, 1000 * tolerance) << "frame " << k << ", mass " << i;
      EXPECT_NEAR(theirs, x[i].x, 1000 * tolerance + 1e-4) << "frame " << k << ", mass " << i;
    }
  }
  std::printf("largest difference from the closed form: %.2g\n", worst);
}

}  // namespace
}  // namespace morphcl
