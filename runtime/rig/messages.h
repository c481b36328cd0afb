#pragma once
#include "base/message.h"

namespace mirada::messages {

inline constexpr Message camera_from_outside{
    "camera_from_outside", "The pictures come from {camera}; wheels and neck are simulated.",
    "Las imágenes vienen de {camera}; las ruedas y el cuello son simulados."};
inline constexpr Message nothing_ships{
    "nothing_ships", "I can't find any {what} in {folder}. Is Mirada installed whole?",
    "No encuentro ningún {what} en {folder}. ¿Está Mirada instalada entera?"};
inline constexpr Message not_offered{"not_offered", "I don't know {name}. Choose one of {known}.",
                                     "No conozco {name}. Elige entre {known}."};
inline constexpr Message robot_closed{"robot_closed", "The robot is being switched off.",
                                      "El robot se está apagando."};

inline constexpr Message kept_camera_broken{
    "kept_camera_broken", "The kept calibration {file} has mistakes, so I don't use it. Calibrate again.",
    "La calibración guardada {file} tiene errores, así que no la uso. Calibra otra vez."};
inline constexpr Message kept_camera_other_size{
    "kept_camera_other_size",
    "The kept calibration is of {theirs} pictures, the robot's are {ours}: I don't use it. Calibrate again.",
    "La calibración guardada es de imágenes de {theirs} y las del robot son de {ours}: no la uso. Calibra "
    "otra "
    "vez."};
inline constexpr Message kept_camera_other_name{
    "kept_camera_other_name",
    "The kept calibration is of a {theirs}, the robot has a {ours}: I don't use it. Calibrate again.",
    "La calibración guardada es de una {theirs} y el robot tiene una {ours}: no la uso. Calibra otra vez."};

inline constexpr Message mount_check_fine{
    "mount_check_fine", "The camera stands as the robot's file says: it looks {tilt} degrees down.",
    "La cámara está como dice el archivo del robot: mira {tilt} grados hacia abajo."};
inline constexpr Message mount_check_no_tag{"mount_check_no_tag",
                                            "I could not check how the camera stands: no AprilTag lies on "
                                            "the floor before it. Distances are as right as "
                                            "the robot's file.",
                                            "No he podido comprobar cómo está la cámara: no hay ninguna "
                                            "AprilTag en el suelo delante. Las distancias son "
                                            "tan buenas como el archivo del robot."};

}  // namespace mirada::messages
