#include "morse/gradient_flow.h"

#include <Eigen/LU>

namespace morskin::morse {

Vector runge_kutta_step(const GradientFlow& flow, const Vector& u, const Vector& velocity,
                        double time) {
  constexpr double s = 4.582575694955840006588047193728;  // the square root of 21
  const double h = time;
  // By components: vector instructions would lengthen the chain of dependent stages.
  const auto stage = [&](auto slope) {
    return flow({u.x() + h * slope(0), u.y() + h * slope(1), u.z() + h * slope(2)});
  };
  const Vector& k1 = velocity;
  const Vector k2 = stage([&](int i) { return k1[i] / 2; });
  const Vector k3 = stage([&](int i) { return (k1[i] + k2[i]) / 4; });
  const Vector k4 = stage(
      [&](int i) { return k1[i] / 7 + (-7 - 3 * s) / 98 * k2[i] + (21 + 5 * s) / 49 * k3[i]; });
  const Vector k5 = stage([&](int i) {
    return (11 + s) / 84 * k1[i] + (18 + 4 * s) / 63 * k3[i] + (21 - s) / 252 * k4[i];
  });
  const Vector k6 = stage([&](int i) {
    return (5 + s) / 48 * k1[i] + (9 + s) / 36 * k3[i] + (-231 + 14 * s) / 360 * k4[i] +
           (63 - 7 * s) / 80 * k5[i];
  });
  const Vector k7 = stage([&](int i) {
    return (10 - s) / 42 * k1[i] + (-432 + 92 * s) / 315 * k3[i] + (633 - 145 * s) / 90 * k4[i] +
           (-504 + 115 * s) / 70 * k5[i] + (63 - 13 * s) / 35 * k6[i];
  });
  const Vector k8 = stage([&](int i) {
    return k1[i] / 14 + (14 - 3 * s) / 126 * k5[i] + (13 - 3 * s) / 63 * k6[i] + k7[i] / 9;
  });
  const Vector k9 = stage([&](int i) {
    return k1[i] / 32 + (91 - 21 * s) / 576 * k5[i] + 11.0 / 72 * k6[i] +
           (-385 - 75 * s) / 1152 * k7[i] + (63 + 13 * s) / 128 * k8[i];
  });
  const Vector k10 = stage([&](int i) {
    return k1[i] / 14 + k5[i] / 9 + (-733 - 147 * s) / 2205 * k6[i] +
           (515 + 111 * s) / 504 * k7[i] + (-51 - 11 * s) / 56 * k8[i] +
           (132 + 28 * s) / 245 * k9[i];
  });
  const Vector k11 = stage([&](int i) {
    return (-42 + 7 * s) / 18 * k5[i] + (-18 + 28 * s) / 45 * k6[i] + (-273 - 53 * s) / 72 * k7[i] +
           (301 + 53 * s) / 72 * k8[i] + (28 - 28 * s) / 45 * k9[i] + (49 - 7 * s) / 18 * k10[i];
  });
  return u + h * (k1 / 20 + 49.0 / 180 * k8 + 16.0 / 45 * k9 + 49.0 / 180 * k10 + k11 / 20);
}

std::optional<Vector> radau_step(const GradientFlow& flow, const Vector& u, const Vector& velocity,
                                 double time) {
  constexpr double s = 2.449489742783178098197284074706;  // the square root of 6
  constexpr double nodes[3] = {(4 - s) / 10, (4 + s) / 10, 1};
  constexpr double weights[3][3] = {
      {(88 - 7 * s) / 360, (296 - 169 * s) / 1800, (-2 + 3 * s) / 225},
      {(296 + 169 * s) / 1800, (88 + 7 * s) / 360, (-2 - 3 * s) / 225},
      {(16 - s) / 36, (16 + s) / 36, 1.0 / 9}};
  constexpr int max_corrections = 12;
  // Where the flow is slow nothing leads back to the patch, so the rounding of a long step would
  // stay. A term that vanishes on the patch, at the rate of the flow, pulls points back.
  const double gradient = flow.gradient(u).norm();
  const double pull = flow.rate(u, gradient) / u.squaredNorm();
  // The rounding of the velocity, a few units of the gradient's, times `time` moves the end along
  // the line; smaller corrections gain nothing there. Across the line they do: one more follows.
  const double rounding = 1e-14 * u.norm() + 1e-15 * time * gradient;
  bool is_near = false;
  Eigen::Matrix<double, 9, 1> z, residual;
  for (int i = 0; i < 3; ++i) z.segment<3>(3 * i) = nodes[i] * time * velocity;
  Eigen::Matrix<double, 9, 9> derivative;
  for (int correction = 0; correction < max_corrections; ++correction) {
    residual = z;
    derivative.setIdentity();
    for (int j = 0; j < 3; ++j) {
      const Vector x = u + z.segment<3>(3 * j);
      const Vector normal = flow.normal(x);
      const Vector stage = flow(x) - pull / 2 * flow.off(x) * normal;
      const Eigen::Matrix3d slope = flow.derivative(x) - pull * normal * normal.transpose();
      for (int i = 0; i < 3; ++i) {
        residual.segment<3>(3 * i) -= time * weights[i][j] * stage;
        derivative.block<3, 3>(3 * i, 3 * j) -= time * weights[i][j] * slope;
      }
    }
    const Eigen::Matrix<double, 9, 1> change = derivative.partialPivLu().solve(residual);
    z -= change;
    if (!(z.norm() < u.norm())) return std::nullopt;
    if (is_near) return u + z.tail<3>();
    is_near = change.norm() < rounding;
  }
  return std::nullopt;
}

}  // namespace morskin::morse
