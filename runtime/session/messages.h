#pragma once
#include "base/message.h"

namespace mirada::messages {

inline constexpr Message program_ended_moving{
    "program_ended_moving", "The program ended, so the robot stopped. Add a wait or a forever.",
    "El programa terminó, así que el robot se paró. Añade un espera o un por siempre."};
inline constexpr Message no_picture{"no_picture",
                                    "No picture comes from the camera, so I can't see where I go. I stopped.",
                                    "La cámara no da imagen y no veo por dónde voy. Me he parado."};
inline constexpr Message robot_stuck{"robot_stuck", "I lost my rhythm for too long, so I stopped to be safe.",
                                     "Perdí el ritmo demasiado tiempo; me paré por seguridad."};
inline constexpr Message no_answer_in_time{"no_answer_in_time", "This block gave no answer in time.",
                                           "Este bloque no respondió a tiempo."};
inline constexpr Message robot_changed{"robot_changed", "The robot was changed. Ask again.",
                                       "El robot ha cambiado. Pregunta otra vez."};

}  // namespace mirada::messages
