#pragma once
#include "base/message.h"

namespace mirada::messages {

inline constexpr Message lab_distance_or_clear{
    "lab_distance_or_clear",
    "{field}: give distance_m (an obstacle) or clear_m (surely free so far), one of them.",
    "{field}: pon distance_m (un obstáculo) o clear_m (libre seguro hasta ahí), uno de los dos."};
inline constexpr Message lab_no_bearings{"lab_no_bearings",
                                         "{field} is empty: give at least one known bearing.",
                                         "{field} está vacío: pon al menos una dirección conocida."};
inline constexpr Message lab_no_pictures{"lab_no_pictures", "{field} must list at least one picture.",
                                         "{field} debe tener al menos una imagen."};
inline constexpr Message lab_format{"lab_format", "{field} must be \"mirada-truth\", not \"{value}\".",
                                    "{field} debe ser «mirada-truth», no «{value}»."};
inline constexpr Message lab_no_picture{"lab_no_picture", "This is no picture that I can read.",
                                        "No es una imagen que pueda leer."};
inline constexpr Message lab_no_folder{"lab_no_folder", "I can't make this folder: {reason}.",
                                       "No puedo crear esta carpeta: {reason}."};
inline constexpr Message lab_choice{"lab_choice", "I don't know {value}. Choose from {known}.",
                                    "No conozco {value}. Elige entre {known}."};

}  // namespace mirada::messages
