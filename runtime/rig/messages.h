#pragma once
#include "base/message.h"

namespace mirada::messages {

inline constexpr Message camera_from_outside{
    "camera_from_outside", "The pictures come from {camera}; wheels and neck are simulated.",
    "Las imágenes vienen de {camera}; las ruedas y el cuello son simulados."};
inline constexpr Message nothing_ships{
    "nothing_ships", "I can't find any {what} in {folder}. Is Mirada installed whole?",
    "No encuentro ningún {what} en {folder}. ¿Está Mirada instalada entera?"};
inline constexpr Message robot_closed{"robot_closed", "The robot is being switched off.",
                                      "El robot se está apagando."};

}  // namespace mirada::messages
