#pragma once
#include "base/message.h"

namespace mirada::hal::messages {

inline constexpr Message camera_missing{"camera_missing",
                                        "There is no camera at {device}. Plug it in, or choose another.",
                                        "No hay ninguna cámara en {device}. Conéctala, o elige otra."};
inline constexpr Message camera_busy{
    "camera_busy", "The camera {device} gives no pictures. Perhaps another program is using it.",
    "La cámara {device} no da imágenes. Quizá la está usando otro programa."};
inline constexpr Message camera_lost{
    "camera_lost", "The camera {device} has stopped sending pictures. Check its plug; I keep trying.",
    "La cámara {device} ha dejado de enviar imágenes. Mira el cable; sigo intentándolo."};
inline constexpr Message pictures_missing{"pictures_missing", "There are no pictures in {file}.",
                                          "No hay imágenes en {file}."};
inline constexpr Message picture_broken{"picture_broken", "{file} is no picture or video that I can read.",
                                        "{file} no es una imagen ni un vídeo que yo sepa leer."};
inline constexpr Message replay_ended{"replay_ended", "The recording {file} has come to its end.",
                                      "La grabación {file} ha llegado al final."};

}  // namespace mirada::hal::messages
