#pragma once
#include "base/message.h"

namespace mirada::messages {

inline constexpr Message lab_legend{
    "lab_legend",
    "error: median and 90th percentile of |said / true - 1| (blocked answers, obstacles to 1.5 m whose foot "
    "is in "
    "the picture); bias: median of said / true - 1; missed: an obstacle reported as clear; imagined: clear "
    "reported "
    "as blocked; in 95 %: truth inside the stated interval; paper: the published geometry on the same "
    "boundaries.",
    "error: mediana y percentil 90 de |dicho / real - 1| (respuestas con obstáculo, hasta 1,5 m y con el pie "
    "en la "
    "imagen); sesgo: mediana de dicho / real - 1; missed: obstáculo dado por libre; imagined: libre dado por "
    "obstáculo; in 95 %: la verdad cae en el intervalo dicho; paper: la geometría publicada con los mismos "
    "bordes."};

}  // namespace mirada::messages
