#pragma once
#include <functional>

#include <Eigen/Core>

namespace mirada::vision {

/// Residuals of a parameter vector; an empty vector where they do not exist.
using Residuals = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

struct LeastSquares {
  bool converged = false;
  Eigen::VectorXd x;
  Eigen::MatrixXd information;  ///< J'J at x: its inverse times the residuals' variance is x's covariance
  double rms = 0;               ///< per residual
};

/// Levenberg-Marquardt with differences for slopes, for the handful of unknowns that a pose has. `step` is
/// each unknown's difference.
LeastSquares minimise(const Residuals& residuals, Eigen::VectorXd start, const Eigen::VectorXd& step);

}  // namespace mirada::vision
