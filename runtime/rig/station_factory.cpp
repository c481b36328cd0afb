#include "rig/station_factory.h"

#include <iostream>

#include "rig/live_station.h"
#include "rig/messages.h"
#include "rig/own_folder.h"
#include "rig/setup_reader.h"
#include "vision/face_finder.h"
#include "vision/messages.h"

namespace mirada::rig {
namespace {

/// The robot's own: one that cannot be read is left as it is, and the robot works without.
Result<std::shared_ptr<vision::FaceBook>> own_faces(const Tell& tell) {
  auto book = vision::FaceBook::open(known_faces_file());
  if (book) return book;
  for (const Fault& why : book.faults()) tell(why);
  tell(make_fault("faces", messages::face_book_left));
  return std::make_shared<vision::FaceBook>();
}

}  // namespace

Result<std::unique_ptr<session::Station>> make_station(const StationOptions& options) {
  session::Setup setup;
  setup.world = options.world;
  setup.robot = options.robot;
  setup.seed = options.seed;
  setup.place = options.place;
  auto parts = read_setup(setup, options.camera);
  if (!parts) return parts.faults();
  const Tell tell = [lang = options.lang](const Fault& word) { std::cerr << word.text(lang) << std::endl; };
  parts->face_model = options.face_model;
  const auto faces = vision::check_face_model(options.face_model);
  if (!faces) return faces.faults();
  auto book = options.faces.empty() ? own_faces(tell) : vision::FaceBook::open(options.faces);
  if (!book) return book.faults();
  parts->book = *book;
  for (const Fault& note : parts->notes) tell(note);
  if (const auto fallback = vision::face_fallback(options.face_model)) tell(*fallback);
  if (const auto fallback = vision::face_identity_fallback(); fallback && (*book)->allowed()) tell(*fallback);
  parts->tell = tell;
  auto robot = LiveRobot::build(*parts);
  if (!robot) return robot.faults();
  if (!options.camera.empty()) {
    std::cerr << format(messages::camera_from_outside, {{"camera", options.camera}}, options.lang) << "\n";
  }
  return std::unique_ptr<session::Station>(
      std::make_unique<LiveStation>(std::move(*robot), options.camera, options.face_model, *book, tell));
}

}  // namespace mirada::rig
