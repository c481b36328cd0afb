#pragma once
#include "base/message.h"

namespace mirada::world::messages {

inline constexpr Message world_unknown{
    "world_unknown", "I don't know the room {name}. Choose one of {known}, or give a file's path.",
    "No conozco la sala {name}. Elige una de {known}, o da la ruta de un archivo."};
inline constexpr Message world_format{
    "world_format", "This is no room file: format must be \"mirada-world\", not {value}.",
    "Esto no es un archivo de sala: format debe ser \"mirada-world\", no {value}."};
inline constexpr Message colour_needed{"colour_needed",
                                       "{field} must be a colour like \"#c08040\", not {value}.",
                                       "{field} debe ser un color como \"#c08040\", no {value}."};
inline constexpr Message bounds_empty{
    "bounds_empty", "{field}: the room must be from {min} to {max} m long and wide; it is {value}.",
    "{field}: la sala debe medir de {min} a {max} m de largo y de ancho; mide {value}."};
inline constexpr Message outside_bounds{
    "outside_bounds", "{field} lies outside the room's bounds (x {min_x} to {max_x}, y {min_y} to {max_y}).",
    "{field} está fuera de los límites de la sala (x de {min_x} a {max_x}, y de {min_y} a {max_y})."};
inline constexpr Message start_blocked{
    "start_blocked", "The start is {value} m from {obstacle}; leave at least {min} m free around it.",
    "La salida está a {value} m de {obstacle}; deja al menos {min} m libres alrededor."};

}  // namespace mirada::world::messages
