#pragma once
#include "base/message.h"

namespace mirada::vm::messages {

// What can be wrong with a program as a file.
inline constexpr Message program_too_large{
    "program_too_large", "This program takes {bytes} bytes; {limit} is the most. Save a smaller one.",
    "Este programa ocupa {bytes} bytes; {limit} es el máximo. Guarda uno menor."};
inline constexpr Message program_not_object{"program_not_object",
                                            "This is no program: it must be an object in braces.",
                                            "Esto no es un programa: debe ser un objeto entre llaves."};
inline constexpr Message workspace_missing{"workspace_missing",
                                           "I find no blocks here: the field workspace.blocks is missing.",
                                           "Aquí no encuentro bloques: falta el campo workspace.blocks."};
inline constexpr Message wrong_version{
    "wrong_version", "This program has format version {value}; I read version 1. Update Mirada.",
    "Este programa tiene la versión de formato {value}; yo leo la 1. Actualiza Mirada."};
inline constexpr Message wrong_shape{"wrong_shape", "{field} must be {expected}, not {value}.",
                                     "{field} debe ser {expected}, no {value}."};
inline constexpr Message too_many_blocks{
    "too_many_blocks", "This program has {count} blocks; {limit} is the most. Make it smaller.",
    "Este programa tiene {count} bloques; {limit} es el máximo. Hazlo más pequeño."};
inline constexpr Message nested_too_deep{
    "nested_too_deep", "Blocks are nested more than {limit} deep here. Split it with my blocks.",
    "Aquí hay más de {limit} bloques anidados. Divídelo con mis bloques."};
inline constexpr Message missing_pack{
    "missing_pack", "This program needs the block pack \"{pack}\", which this robot does not have.",
    "Este programa necesita el paquete de bloques «{pack}», que este robot no tiene."};
inline constexpr Message duplicate_id{"duplicate_id",
                                      "Two blocks have the same id {id}. Copy one of them again.",
                                      "Dos bloques tienen el mismo id {id}. Vuelve a copiar uno de ellos."};
inline constexpr Message duplicate_variable{"duplicate_variable", "Two variables have the same id {id}.",
                                            "Dos variables tienen el mismo id {id}."};

inline constexpr Message project_broken{
    "project_broken",
    "This file is no Scratch project (.sb3), or only a piece of one: I could read it up to byte {byte}. Save "
    "it again from Scratch.",
    "Este archivo no es un proyecto de Scratch (.sb3), o solo un trozo: he podido leerlo hasta el byte "
    "{byte}. Guárdalo otra vez desde Scratch."};
inline constexpr Message no_targets{
    "no_targets", "This is no Scratch project: it has no list of sprites (targets).",
    "Esto no es un proyecto de Scratch: no tiene lista de objetos (targets)."};
inline constexpr Message no_stage{"no_stage", "This Scratch project has no stage; it gets an empty one.",
                                  "Este proyecto de Scratch no tiene escenario; se le da uno vacío."};
inline constexpr Message old_scratch{
    "old_scratch",
    "This project is from Scratch {version}. Open it in Scratch 3, save it, and open that file.",
    "Este proyecto es de Scratch {version}. Ábrelo en Scratch 3, guárdalo y abre ese archivo."};
inline constexpr Message only_a_sprite{
    "only_a_sprite", "This file holds one Scratch sprite, not a project. Save the project.",
    "Este archivo tiene un objeto de Scratch, no un proyecto. Guarda el proyecto."};
inline constexpr Message too_many_parameters{
    "too_many_parameters", "The block \"{name}\" has {count} parameters; {limit} is the most.",
    "El bloque «{name}» tiene {count} parámetros; {limit} es el máximo."};
inline constexpr Message archive_broken{
    "archive_broken", "This is no Scratch file: I can't unpack it. Save it again from Scratch.",
    "Esto no es un archivo de Scratch: no puedo abrirlo. Guárdalo otra vez desde Scratch."};
inline constexpr Message archive_without_project{"archive_without_project",
                                                 "There is no project.json in this Scratch file.",
                                                 "En este archivo de Scratch no hay project.json."};
inline constexpr Message archive_too_large{
    "archive_too_large", "The project in this Scratch file takes more than {limit_mib} MiB.",
    "El proyecto de este archivo de Scratch ocupa más de {limit_mib} MiB."};
inline constexpr Message stage_blocks{
    "stage_blocks", "These blocks need Scratch's stage and do nothing here: {blocks}.",
    "Estos bloques necesitan el escenario de Scratch y aquí no hacen nada: {blocks}."};
inline constexpr Message list_left_empty{
    "list_left_empty",
    "The list \"{name}\" has {count} items; only up to {limit} come along, so it is empty.",
    "La lista «{name}» tiene {count} elementos; solo vienen hasta {limit}, así que está vacía."};
inline constexpr Message placeholder_blocks{
    "placeholder_blocks",
    "The robot has no such blocks; they are grey and must come out before it runs: {blocks}.",
    "El robot no tiene estos bloques; están en gris y hay que quitarlos para ejecutar: {blocks}."};

// What can be wrong with a block.
inline constexpr Message unknown_block{"unknown_block",
                                       "I don't know the block \"{opcode}\". Take it out to run.",
                                       "No conozco el bloque «{opcode}». Quítalo para ejecutar."};
inline constexpr Message not_a_command{"not_a_command",
                                       "This block gives a value; it can't stand in a stack.",
                                       "Este bloque da un valor; no puede ir en una pila."};
inline constexpr Message not_a_value{"not_a_value", "This block gives no value; it can't stand in a slot.",
                                     "Este bloque no da ningún valor; no puede ir en un hueco."};
inline constexpr Message hat_inside{"hat_inside", "This block must stand at the top of a stack.",
                                    "Este bloque debe ir al principio de una pila."};
inline constexpr Message after_cap{"after_cap",
                                   "Nothing can follow this block, so what hangs below never runs.",
                                   "Nada puede seguir a este bloque: lo que cuelga debajo nunca se ejecuta."};
inline constexpr Message field_absent{"field_absent", "This block lacks its choice {field}.",
                                      "A este bloque le falta la opción {field}."};
inline constexpr Message wrong_choice{"wrong_choice", "{field} must be one of {choices}, not \"{value}\".",
                                      "{field} debe ser uno de {choices}, no «{value}»."};
inline constexpr Message not_a_number{"field_not_a_number", "{field} must be a number, not \"{value}\".",
                                      "{field} debe ser un número, no «{value}»."};
inline constexpr Message out_of_range{"out_of_range",
                                      "{value} is unusual here; sensible values go from {min} to {max}.",
                                      "{value} es raro aquí; lo sensato va de {min} a {max}."};
inline constexpr Message below_range{"below_range",
                                     "{value} is unusual here; sensible values begin at {min}.",
                                     "{value} es raro aquí; lo sensato empieza en {min}."};
inline constexpr Message above_range{"above_range", "{value} is unusual here; sensible values end at {max}.",
                                     "{value} es raro aquí; lo sensato acaba en {max}."};
inline constexpr Message unknown_input{"unknown_input",
                                       "This block has no slot {field}; what is in it is ignored.",
                                       "Este bloque no tiene el hueco {field}; lo que contiene no se usa."};
inline constexpr Message unknown_field{"unknown_field", "This block has no choice {field}; it is ignored.",
                                       "Este bloque no tiene la opción {field}; no se usa."};
inline constexpr Message dangling_variable{
    "dangling_variable",
    "The {kind} of this block is not in the program any more (id {id}). Choose one again.",
    "La {kind} de este bloque ya no está en el programa (id {id}). Elige otra vez."};
inline constexpr Message block_cycle{
    "block_cycle", "What follows this block, {id}, hangs elsewhere already. It is left out here.",
    "Lo que sigue a este bloque, {id}, ya está unido en otro sitio. Aquí se omite."};
inline constexpr Message dangling_block{
    "dangling_block", "This block names the block {id}, which is not there. It is left out.",
    "Este bloque nombra el bloque {id}, que no existe. Se omite."};

// My blocks.
inline constexpr Message signature_missing{"signature_missing",
                                           "This my-block has lost its name and parameters.",
                                           "Este bloque propio ha perdido su nombre y sus parámetros."};
inline constexpr Message two_definitions{"two_definitions",
                                         "The block \"{name}\" is defined twice. Delete one.",
                                         "El bloque «{name}» está definido dos veces. Borra una."};
inline constexpr Message two_parameters{"two_parameters",
                                        "Two parameters have the name \"{name}\". Rename one.",
                                        "Dos parámetros se llaman «{name}». Cambia el nombre de uno."};
inline constexpr Message no_definition{
    "no_definition", "The block \"{name}\" is not defined anywhere, so it does nothing.",
    "El bloque «{name}» no está definido en ningún sitio, así que no hace nada."};
inline constexpr Message gives_no_value{"gives_no_value", "The block \"{name}\" gives no value back.",
                                        "El bloque «{name}» no devuelve ningún valor."};
inline constexpr Message parameter_elsewhere{"parameter_elsewhere",
                                             "There is no parameter \"{name}\" here; it counts as 0.",
                                             "Aquí no hay ningún parámetro «{name}»; vale 0."};
inline constexpr Message return_elsewhere{"return_elsewhere",
                                          "Outside a my-block, return only stops the script.",
                                          "Fuera de un bloque propio, devolver solo detiene el programa."};

// What can go wrong while a program runs.
inline constexpr Message text_too_long{"text_over_limit", "This text would be longer than {limit} bytes.",
                                       "Este texto tendría más de {limit} bytes."};
inline constexpr Message out_of_memory{
    "out_of_memory", "The program's lists and texts take more than {limit_mib} MiB. Empty some.",
    "Las listas y textos del programa ocupan más de {limit_mib} MiB. Vacía alguna."};
inline constexpr Message too_deep{
    "too_deep", "This block calls itself more than {limit} times. Does it ever come to an end?",
    "Este bloque se llama a sí mismo más de {limit} veces. ¿Termina alguna vez?"};
inline constexpr Message too_many_scripts{"too_many_scripts", "More than {limit} scripts would run at once.",
                                          "Se ejecutarían más de {limit} programas a la vez."};
inline constexpr Message no_such_reporter{"no_such_reporter",
                                          "There is no block here that can show its value.",
                                          "Aquí no hay ningún bloque que pueda mostrar su valor."};
inline constexpr Message answer_gave_up{"answer_gave_up",
                                        "The program stopped before this block had a value.",
                                        "El programa paró antes de que este bloque tuviera un valor."};

}  // namespace mirada::vm::messages
