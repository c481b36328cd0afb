// Who is it? Five people are learnt, five are strangers; every question is one picture that was not learnt
// from. Prints one JSON object. With two folders (a folder a person in each): with those pictures instead.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iostream>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "base/random.h"
#include "model/robot_config.h"
#include "vision/faces/face_net.h"
#include "vision/identity/face_namer.h"
#include "world/render/renderer.h"

namespace {

using namespace mirada;
using nlohmann::json;
namespace fs = std::filesystem;

constexpr int kLooks = 8;
constexpr int kQuestions = 40;  // a person

/// A picture of somebody: the same person and variant give the same picture.
using Show = std::function<cv::Mat(int person, int variant)>;

struct Set {
  std::string what;
  int learnt = 0, strangers = 0;
  Show show;
};

void add_noise(cv::Mat& bgr, double sigma, std::uint64_t seed) {
  cv::Mat noise(bgr.size(), CV_16SC3);
  cv::RNG chance(seed);
  chance.fill(noise, cv::RNG::NORMAL, 0, sigma);
  cv::add(bgr, noise, bgr, {}, CV_8U);
}

world::PersonConfig painted_person(int person) {
  world::PersonConfig out;
  out.height_m = 1.4;
  out.face = 1 + person;
  world::wear_own_colours(out);
  return out;
}

/// Somebody of the simulated room, 0.6 to 1.4 m away, turned by up to 25 degrees, in light from half to one
/// and a half; to be learnt nearer by and turned less.
cv::Mat painted(int person, int variant, const RobotConfig& robot) {
  const bool to_learn = variant < kLooks;
  Random chance(static_cast<std::uint64_t>(1000 * person + variant), "painted variants");
  world::WorldConfig room = *world::world_by_name("sala-1");
  room.people = {painted_person(person)};
  room.light.level = to_learn ? 1 : chance.uniform(0.5, 1.5);
  const double away_m = chance.uniform(0.6, to_learn ? 0.9 : 1.4);
  const double most = rad(to_learn ? 15 : 25);
  const double turned = chance.uniform(-most, most);
  world::Renderer renderer(room, robot.camera, static_cast<std::uint64_t>(variant) + 1);
  Eigen::Isometry3d X_WC = robot.X_RC({0, -robot.mount.tilt_rad});
  X_WC.translation() =
      Eigen::Vector3d(room.X_WR_start.x_m, room.X_WR_start.y_m, room.people[0].height_m - 0.12);
  const Pose2 X_WP{room.X_WR_start.x_m + away_m, room.X_WR_start.y_m + chance.uniform(-0.15, 0.15) * away_m,
                   M_PI + turned};
  return renderer.render(X_WC, {X_WP}, variant);
}

struct Head {
  cv::Mat bgr;
  cv::Rect2d face;
};

/// Somebody at two moments, and somebody else.
std::vector<Head> photographed_heads() {
  const std::string folder = "/usr/share/doc/opencv-doc/examples/data/";
  const cv::Mat a = cv::imread(folder + "basketball1.png");
  const cv::Mat later = cv::imread(folder + "basketball2.png");
  const cv::Mat b = cv::imread(folder + "messi5.jpg");
  if (a.empty() || later.empty() || b.empty()) return {};
  const cv::Rect2d face(21, 22, 34, 42);
  return {{a(cv::Rect(50, 70, 75, 90)), face},
          {later(cv::Rect(50, 70, 75, 90)), face},
          {b(cv::Rect(195, 65, 95, 95)), {31, 27, 31, 40}}};
}

/// A head turned in the picture, scaled to faces of 30 to 70 pixels, in other light, with noise.
cv::Mat photographed(const Head& head, int variant) {
  Random chance(static_cast<std::uint64_t>(variant), "photographed variants");
  const cv::Point2d middle(head.face.x + head.face.width / 2, head.face.y + head.face.height / 2);
  const double scale = chance.uniform(30, 70) / head.face.width;
  cv::Matx23d to(cv::Mat(cv::getRotationMatrix2D(middle, chance.uniform(-12, 12), scale)));
  to(0, 2) += 160 - middle.x;
  to(1, 2) += 120 - middle.y;
  cv::Mat out;
  cv::warpAffine(head.bgr, out, to, {320, 240}, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  if (chance.uniform() < 0.5) cv::GaussianBlur(out, out, {0, 0}, chance.uniform(0.3, 1.0));
  out.convertTo(out, -1, chance.uniform(0.45, 1.35), chance.uniform(-12, 12));
  add_noise(out, 3, static_cast<std::uint64_t>(variant) + 1);
  return out;
}

class Exam {
 public:
  Exam(vision::FaceNet& net, vision::FaceDescriber describer) : net_(net), describer_(std::move(describer)) {}

  std::optional<vision::FaceFeature> feature(const cv::Mat& bgr) {
    const std::vector<vision::FaceBox> found = net_.find(bgr);
    const auto largest = std::max_element(found.begin(), found.end(), [](const auto& a, const auto& b) {
      return a.box_px.area() < b.box_px.area();
    });
    return largest == found.end() ? std::nullopt : describer_.describe(bgr, largest->box_px);
  }
  void learn(const std::string& name, const std::vector<cv::Mat>& pictures) {
    std::vector<vision::FaceFeature> looks;
    for (const cv::Mat& bgr : pictures)
      if (auto one = feature(bgr)) looks.push_back(std::move(*one));
    if (!looks.empty()) (void)book_.learn(name, describer_.kind(), looks);
  }
  /// `name`: "" for a stranger.
  void ask(const std::string& name, const cv::Mat& bgr) {
    const auto one = feature(bgr);
    if (!one) {
      ++unseen_;
      return;
    }
    const vision::FaceBook::Match match = book_.match(*one, describer_.kind());
    const std::string said = vision::FaceNamer::name_by(match, describer_.same_from());
    if (name.empty()) {
      ++strangers_;
      named_ += !said.empty();
      stranger_likeness_.push_back(match.likeness);
    } else {
      ++known_;
      right_ += said == name;
      wrong_ += !said.empty() && said != name;
      known_likeness_.push_back(match.name == name ? match.likeness : match.next_likeness);
    }
  }
  json row(const std::string& what) {
    const auto share = [](std::vector<double>& all, double at) {
      std::sort(all.begin(), all.end());
      return all.empty() ? 0.0 : all[static_cast<std::size_t>(at * static_cast<double>(all.size() - 1))];
    };
    return {{"what", what},
            {"how", describer_.kind()},
            {"known", known_},
            {"right", right_},
            {"wrong", wrong_},
            {"strangers", strangers_},
            {"named", named_},
            {"unseen", unseen_},
            {"same_from", describer_.same_from()},
            {"known_5_percent", share(known_likeness_, 0.05)},
            {"known_median", share(known_likeness_, 0.5)},
            {"strangers_median", share(stranger_likeness_, 0.5)},
            {"strangers_97_percent", share(stranger_likeness_, 0.97)}};
  }

 private:
  vision::FaceNet& net_;
  vision::FaceDescriber describer_;
  vision::FaceBook book_;
  int known_ = 0, right_ = 0, wrong_ = 0, strangers_ = 0, named_ = 0, unseen_ = 0;
  std::vector<double> known_likeness_, stranger_likeness_;
};

json examine(const Set& set, vision::FaceNet& net, vision::FaceDescriber describer) {
  Exam exam(net, std::move(describer));
  for (int person = 0; person < set.learnt; ++person) {
    std::vector<cv::Mat> pictures;
    for (int i = 0; i < kLooks; ++i) pictures.push_back(set.show(person, i));
    exam.learn("person " + std::to_string(person), pictures);
  }
  for (int person = 0; person < set.learnt + set.strangers; ++person) {
    const std::string name = person < set.learnt ? "person " + std::to_string(person) : "";
    for (int i = 0; i < kQuestions; ++i) exam.ask(name, set.show(person, kLooks + i));
  }
  json out = exam.row(set.what);
  out["learnt_people"] = set.learnt;
  out["stranger_people"] = set.strangers;
  return out;
}

std::vector<fs::path> sorted(const fs::path& folder) {
  std::vector<fs::path> out;
  for (const auto& entry : fs::directory_iterator(folder)) out.push_back(entry.path());
  std::sort(out.begin(), out.end());
  return out;
}

/// Of each learnt person the first `looks` pictures are learnt; the others are asked.
json examine_folders(const fs::path& learnt, const fs::path& strangers, std::size_t looks,
                     vision::FaceNet& net, vision::FaceDescriber describer) {
  Exam exam(net, std::move(describer));
  for (const fs::path& person : sorted(learnt)) {
    std::vector<cv::Mat> pictures;
    for (const fs::path& file : sorted(person))
      if (pictures.size() < looks) pictures.push_back(cv::imread(file.string()));
    exam.learn(person.filename().string(), pictures);
  }
  for (const fs::path& person : sorted(learnt)) {
    const std::vector<fs::path> files = sorted(person);
    for (std::size_t i = looks; i < files.size(); ++i)
      exam.ask(person.filename().string(), cv::imread(files[i].string()));
  }
  for (const fs::path& person : sorted(strangers))
    for (const fs::path& file : sorted(person)) exam.ask("", cv::imread(file.string()));
  return exam.row("own pictures");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Who is it? Measured with people who were learnt and people who were not."};
  std::string learnt, strangers;
  std::size_t looks = 8;
  app.add_option("--learnt", learnt, "A folder with a folder of pictures a person: the first are learnt");
  app.add_option("--strangers", strangers, "A folder with a folder of pictures a person");
  app.add_option("--looks", looks, "Pictures to learn from, with --learnt")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  cv::setNumThreads(1);
  auto net = vision::FaceNet::open(vision::FaceNet::default_file());
  const std::vector<Head> heads = photographed_heads();
  if (!net || heads.empty() || vision::FaceDescriber::open().kind() != "network-1") {
    std::cerr << "the face models or opencv-doc are missing\n";
    return 2;
  }
  const RobotConfig robot = *robot_by_name("mirada-sim");
  const Set painted_set{"painted", 5, 5,
                        [&](int person, int variant) { return painted(person, variant, robot); }};
  const Set photographs{"photographed", 1, 1, [&](int person, int variant) {
                          const std::size_t later = variant < kLooks ? 0 : 1;
                          return photographed(heads[person == 0 ? later : 2], variant);
                        }};
  json rows = json::array();
  for (const auto& open : {vision::FaceDescriber::open, vision::FaceDescriber::plain}) {
    if (learnt.empty()) {
      for (const Set* set : {&painted_set, &photographs}) rows.push_back(examine(*set, *net, open()));
    } else {
      rows.push_back(examine_folders(learnt, strangers, looks, *net, open()));
    }
  }
  std::cout << json{{"looks", learnt.empty() ? kLooks : looks}, {"rows", rows}}.dump(1) << "\n";
}
