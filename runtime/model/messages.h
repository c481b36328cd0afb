#pragma once
#include "base/message.h"

namespace mirada::messages {

inline constexpr Message robot_unknown{
    "robot_unknown", "I don't know the robot {robot}. Choose {known}, or give a robot.json file.",
    "No conozco el robot {robot}. Elige {known}, o da un archivo robot.json."};
inline constexpr Message robot_wrong_version{"robot_wrong_version",
                                             "{field} is {value}; this program reads version 1.",
                                             "{field} es {value}; este programa lee la versión 1."};
inline constexpr Message robot_wrong_format{
    "robot_wrong_format", "{field} must be \"mirada-robot\", not {value}. Is this a robot file?",
    "{field} debe ser \"mirada-robot\", no {value}. ¿Es un archivo de robot?"};
inline constexpr Message camera_view_missing{
    "camera_view_missing", "Say how wide the camera sees: {field} (1 to 175), or fx_px from a calibration.",
    "Di cuánto abarca la cámara: {field} (de 1 a 175), o fx_px de una calibración."};
inline constexpr Message camera_view_twice{
    "camera_view_twice",
    "{field} {value} and fx_px do not belong together: this fx_px sees {seen} degrees. Keep one of them.",
    "{field} {value} y fx_px no concuerdan: ese fx_px abarca {seen} grados. Deja uno de los dos."};
inline constexpr Message camera_distortion_folds{
    "camera_distortion_folds",
    "{field} cannot be right: with it the pixel {pixel} is seen by no ray. Calibrate again.",
    "{field} no puede ser correcto: con él ningún rayo ve el píxel {pixel}. Calibra de nuevo."};
inline constexpr Message range_reversed{"range_reversed",
                                        "{field} is {value}; it must not be below min_deg ({min}).",
                                        "{field} es {value}; no puede ser menor que min_deg ({min})."};
inline constexpr Message faster_than_possible{
    "faster_than_possible", "{field} is {value}; it must not be above max_wheel_mps ({max}).",
    "{field} es {value}; no puede pasar de max_wheel_mps ({max})."};
inline constexpr Message footprint_points{
    "footprint_points",
    "{field} must be a list of 3 to 64 corners [x, y] in metres from -2 to 2, not {value}.",
    "{field} debe ser una lista de 3 a 64 esquinas [x, y] en metros de -2 a 2, no {value}."};
inline constexpr Message footprint_not_convex{
    "footprint_not_convex",
    "{field}: the corners must go round the robot without a dent or a crossing; look at corner {corner}.",
    "{field}: las esquinas deben rodear el robot sin entrantes ni cruces; mira la esquina {corner}."};
inline constexpr Message camera_underground{
    "camera_underground",
    "{field}: with the neck at {tilt_deg} degrees of tilt the lens would be {height_m} m high.",
    "{field}: con el cuello a {tilt_deg} grados de inclinación la lente quedaría a {height_m} m de altura."};
inline constexpr Message camera_said_twice{"camera_said_twice",
                                           "{field} is already in the calibration. Take it out here.",
                                           "{field} ya está en la calibración. Quítalo de aquí."};
inline constexpr Message camera_file_other_camera{
    "camera_file_other_camera",
    "{field} was made with the camera \"{theirs}\", but this robot has \"{ours}\". Calibrate this camera.",
    "{field} se hizo con la cámara \"{theirs}\", pero este robot lleva \"{ours}\". Calibra esta cámara."};
inline constexpr Message camera_file_other_view{
    "camera_file_other_view",
    "{field} is of a camera that sees {seen} degrees, but hfov_deg is {value}. Calibrate this camera.",
    "{field} es de una cámara que abarca {seen} grados, pero hfov_deg es {value}. Calibra esta cámara."};
inline constexpr Message camera_file_other_size{
    "camera_file_other_size",
    "{field} was made with {theirs} pictures; {ours} has another shape. Calibrate at the size that you use.",
    "{field} se hizo con imágenes de {theirs}; {ours} tiene otra forma. Calibra con el tamaño que uses."};
inline constexpr Message camera_file_wrong_format{
    "camera_file_wrong_format", "{field} must be \"mirada-camera\", not {value}. Is this a camera.json?",
    "{field} debe ser \"mirada-camera\", no {value}. ¿Es un camera.json?"};
inline constexpr Message preset_unknown{"preset_unknown",
                                        "I don't know the camera {camera}. Choose {known}, or leave it out.",
                                        "No conozco la cámara {camera}. Elige {known}, o no la digas."};
inline constexpr Message preset_modes_missing{"preset_modes_missing",
                                              "{field} must list at least one picture mode.",
                                              "{field} debe tener al menos un modo de imagen."};

inline constexpr Message point_needed{
    "point_needed", "{field} must be a point [x, y] in metres, each from {min} to {max}, not {value}.",
    "{field} debe ser un punto [x, y] en metros, cada uno de {min} a {max}, no {value}."};
inline constexpr Message points_needed{"points_needed",
                                       "{field} must be a list of {min} to {max} points [x, y].",
                                       "{field} debe ser una lista de {min} a {max} puntos [x, y]."};
inline constexpr Message points_or_circle{"points_or_circle", "{field} needs points or a circle.",
                                          "{field} necesita points o circle."};

inline constexpr Message place_unknown{
    "place_unknown", "I don't know the place {name}. Choose {known}, or give a place.json file.",
    "No conozco el lugar {name}. Elige {known}, o da un archivo place.json."};
inline constexpr Message place_format{
    "place_format", "{field} must be \"mirada-place\", not {value}. Is this a place file?",
    "{field} debe ser \"mirada-place\", no {value}. ¿Es un archivo de lugar?"};
inline constexpr Message place_tag_id{"place_tag_id",
                                      "{field} is {value}; it must be a whole number, 0 to 586.",
                                      "{field} es {value}; debe ser un número entero, de 0 a 586."};
inline constexpr Message place_tag_twice{
    "place_tag_twice", "{field}: tag {value} is there twice. Each tag may hang at one place only.",
    "{field}: la etiqueta {value} está dos veces. Cada etiqueta solo puede estar en un sitio."};
inline constexpr Message place_line_short{
    "place_line_short", "{field} is {value} m from the point before it; it must be {min} m or more.",
    "{field} está a {value} m del punto anterior; debe estar a {min} m o más."};

}  // namespace mirada::messages
