#pragma once
#include "base/message.h"

namespace mirada::messages {

inline constexpr Message calibrate_view{"calibrate_view", "{image}: {rms} px, board tilted {tilt} degrees",
                                        "{image}: {rms} px, tablero inclinado {tilt} grados"};
inline constexpr Message calibrate_lens{"calibrate_lens",
                                        "lens {lens}: fx {fx} (+- {sigma}), fy {fy}, centre {cx}, {cy} px",
                                        "lente {lens}: fx {fx} (+- {sigma}), fy {fy}, centro {cx}, {cy} px"};
inline constexpr Message calibrate_view_angle{
    "calibrate_view_angle", "sees {hfov} x {vfov} degrees ({seen} across through the lens's bend)",
    "abarca {hfov} x {vfov} grados ({seen} a lo ancho contando la curva de la lente)"};
inline constexpr Message calibrate_result{
    "calibrate_result",
    "rms {rms} px, {used} of {given} pictures used, board shown in {coverage} % of the picture",
    "rms {rms} px, {used} de {given} imágenes usadas, tablero enseñado en el {coverage} % de la imagen"};
inline constexpr Message calibrate_not_kept{"calibrate_not_kept",
                                            "Not kept: give --out camera.json to write it.",
                                            "No se ha guardado: pon --out camera.json para escribirlo."};

}  // namespace mirada::messages
