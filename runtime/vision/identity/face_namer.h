#pragma once
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "model/percepts.h"
#include "vision/identity/face_book.h"

namespace mirada::vision {

/// Says who the faces are that are followed, and takes the looks of a lesson. At most one face of a picture
/// is looked at closely, seldom once it is known. Does nothing while the book does not allow it. One thread.
class FaceNamer {
 public:
  explicit FaceNamer(std::shared_ptr<FaceBook> book) : book_(std::move(book)) {}

  /// After the tracker. `may_describe`: this picture was searched, its boxes are the detector's own.
  void look(const cv::Mat& bgr, FacesPercept& seen, bool may_describe);
  /// The name that this match gives, "" for nobody known; `same_from` of the describer.
  static std::string name_by(const FaceBook::Match& match, double same_from);
  /// Of a picture that stands alone: every face by one look.
  void name_at_once(const cv::Mat& bgr, FacesPercept& seen);
  void forget();

 private:
  struct Track {
    std::deque<std::string> votes;  ///< the newest looks: a name, or "" for nobody known
    std::optional<std::string> who;
    Micros asked_at = 0;
  };

  void follow_book();
  FacePercept* most_wanted(FacesPercept& seen);
  void ask(const cv::Mat& bgr, FacesPercept& seen);
  void learn(const cv::Mat& bgr, FacesPercept& seen, std::uint64_t lesson);
  std::string who(const FaceFeature& feature) const;
  std::optional<FaceFeature> describe(const cv::Mat& bgr, FacesPercept& seen, const FacePercept& face);
  static void decide(Track& track);

  std::shared_ptr<FaceBook> book_;
  std::optional<FaceDescriber> describer_;
  std::map<int, Track> tracks_;
  std::uint64_t revision_ = 0;
  std::uint64_t lesson_ = 0;
  int pupil_ = 0;  ///< whose lesson it is
  Micros taught_at_ = 0;
  Micros shown_at_ = 0;  ///< when the lesson last saw a face
};

}  // namespace mirada::vision
