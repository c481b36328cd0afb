#pragma once

namespace mirada::vm {

// Natural logarithm, exponential and power of ten to the last bit as JavaScript engines give them: they
// follow the reductions and coefficients that Sun published with fdlibm, while C libraries round a little
// differently.
double logarithm(double x);
double exponential(double x);
double power_of_ten(double x);

}  // namespace mirada::vm
