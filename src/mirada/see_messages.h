#pragma once
#include "base/message.h"

namespace mirada::messages {

inline constexpr Message see_no_picture{"see_no_picture", "{file} is no picture or video that I can read.",
                                        "{file} no es una imagen ni un vídeo que pueda leer."};
inline constexpr Message see_wrong_shape{"see_wrong_shape",
                                         "{file} is {width} x {height}; the robot's camera takes "
                                         "{camera_width} x {camera_height}. Use a picture of that shape, "
                                         "or describe its camera in the robot file.",
                                         "{file} es de {width} x {height}; la cámara del robot hace "
                                         "{camera_width} x {camera_height}. Usa una imagen de esa "
                                         "forma, o describe su cámara en el archivo del robot."};
inline constexpr Message see_overlay_type{
    "see_overlay_type", "I can't draw to {file}: its name must end in .png or .jpg.",
    "No puedo dibujar en {file}: su nombre debe terminar en .png o .jpg."};
inline constexpr Message see_overlay_unwritten{"see_overlay_unwritten", "I can't write the picture {file}.",
                                               "No puedo escribir la imagen {file}."};
inline constexpr Message see_nearest{
    "see_nearest", "{image}: nearest obstacle {cm} cm away, {degrees} degrees to the {side}.",
    "{image}: el obstáculo más cercano está a {cm} cm, {degrees} grados a la {side}."};
inline constexpr Message see_ahead{"see_ahead", "{image}: nearest obstacle {cm} cm away, straight ahead.",
                                   "{image}: el obstáculo más cercano está a {cm} cm, justo delante."};
inline constexpr Message see_free{"see_free", "{image}: no obstacle seen.",
                                  "{image}: no se ve ningún obstáculo."};
inline constexpr Message see_no_floor{
    "see_no_floor",
    "{image}: I can't see the floor here. Tilt the camera down a little, or give it more room.",
    "{image}: aquí no veo el suelo. Inclina un poco la cámara hacia abajo, o dale más espacio."};
inline constexpr Message see_faces{"see_faces", "{image}: faces seen: {count}.",
                                   "{image}: caras vistas: {count}."};

}  // namespace mirada::messages
