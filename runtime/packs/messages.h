#pragma once
#include "base/message.h"

namespace mirada::packs::messages {

inline constexpr Message wrong_name{
    "wrong_name", "{field} must be made of small letters, digits and _ (at most 60), not {value}.",
    "{field} debe estar hecho de minúsculas, cifras y _ (60 como máximo), no {value}."};
inline constexpr Message wrong_colour{"wrong_colour",
                                      "{field} must be a colour such as #4C97FF, not {value}.",
                                      "{field} debe ser un color como #4C97FF, no {value}."};
inline constexpr Message wrong_default{"wrong_default", "{field} must be a number or a text, not {value}.",
                                       "{field} debe ser un número o un texto, no {value}."};
inline constexpr Message default_not_offered{"default_not_offered",
                                             "{field} is {value}, which is none of the options {choices}.",
                                             "{field} es {value}, que no está entre las opciones {choices}."};
inline constexpr Message empty_list{"empty_list", "{field} is empty; at least one is needed.",
                                    "{field} está vacío; hace falta al menos uno."};
inline constexpr Message range_upside_down{"range_upside_down", "{field}: min {min} is above max {max}.",
                                           "{field}: min {min} está por encima de max {max}."};
inline constexpr Message twice{"twice", "{field}: {value} is there twice.",
                               "{field}: {value} está dos veces."};
inline constexpr Message placeholder_missing{"placeholder_missing",
                                             "{field} does not say where [{value}] goes, or says it twice.",
                                             "{field} no dice dónde va [{value}], o lo dice dos veces."};
inline constexpr Message placeholder_unknown{"placeholder_unknown",
                                             "{field} names [{value}], which is none of the arguments.",
                                             "{field} nombra [{value}], que no es ningún argumento."};
inline constexpr Message code_missing{
    "code_missing", "{field}: there is no code for the native block {value} in this robot's program.",
    "{field}: no hay código para el bloque nativo {value} en el programa de este robot."};
inline constexpr Message opcode_taken{"opcode_taken",
                                      "The block {opcode} of the pack {pack} is there already.",
                                      "El bloque {opcode} del paquete {pack} ya existe."};
inline constexpr Message wrong_format{
    "wrong_format", "{field} is {value}; I read pack format 1. Update Mirada.",
    "{field} es {value}; yo leo el formato de paquete 1. Actualiza Mirada."};

}  // namespace mirada::packs::messages
