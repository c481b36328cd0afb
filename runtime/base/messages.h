#pragma once
#include "base/message.h"

namespace mirada::messages {

inline constexpr Message file_missing{"file_missing", "There is no file {file}.",
                                      "No existe el archivo {file}."};
inline constexpr Message file_is_folder{"file_is_folder", "{file} is a folder; a file is needed here.",
                                        "{file} es una carpeta; aquí hace falta un archivo."};
inline constexpr Message file_unreadable{"file_unreadable", "I can't read {file}. Check who may read it.",
                                         "No puedo leer {file}. Mira quién tiene permiso de lectura."};
inline constexpr Message file_too_large{"file_too_large", "{file} is larger than {limit_mib} MiB.",
                                        "{file} ocupa más de {limit_mib} MiB."};
inline constexpr Message file_not_written{"file_not_written", "I can't write {file}: {reason}.",
                                          "No puedo escribir {file}: {reason}."};
inline constexpr Message json_broken{"json_broken", "This is not whole JSON: it breaks at byte {byte}.",
                                     "Esto no es JSON completo: se rompe en el byte {byte}."};
inline constexpr Message json_number_too_large{
    "json_number_too_large", "A number in this JSON is too large to hold. Make it smaller.",
    "Un número de este JSON es demasiado grande. Hazlo más pequeño."};
inline constexpr Message object_needed{"object_needed", "{field} must be an object in braces, not {value}.",
                                       "{field} debe ser un objeto entre llaves, no {value}."};
inline constexpr Message array_needed{"array_needed",
                                      "{field} must be a list of {min} to {max} values, not {value}.",
                                      "{field} debe ser una lista de {min} a {max} valores, no {value}."};
inline constexpr Message number_needed{"number_needed",
                                       "{field} must be a number from {min} to {max}, not {value}.",
                                       "{field} debe ser un número de {min} a {max}, no {value}."};
inline constexpr Message text_needed{"text_needed", "{field} must be a text, not {value}.",
                                     "{field} debe ser un texto, no {value}."};
inline constexpr Message truth_needed{"truth_needed", "{field} must be true or false, not {value}.",
                                      "{field} debe ser true o false, no {value}."};
inline constexpr Message choice_needed{"choice_needed", "{field} must be one of {choices}, not {value}.",
                                       "{field} debe ser uno de {choices}, no {value}."};
inline constexpr Message choice_missing{"choice_missing", "{field} is missing: one of {choices}.",
                                        "Falta {field}: uno de {choices}."};
inline constexpr Message number_missing{"number_missing", "{field} is missing: a number from {min} to {max}.",
                                        "Falta {field}: un número de {min} a {max}."};
inline constexpr Message field_missing{"field_missing", "{field} is missing.", "Falta {field}."};
inline constexpr Message field_unknown{"field_unknown",
                                       "I don't know the field {field}. Known here: {known}.",
                                       "No conozco el campo {field}. Aquí valen: {known}."};

}  // namespace mirada::messages
