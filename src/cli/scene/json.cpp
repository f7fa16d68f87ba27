#include "sample.hpp"
#include "scene/text.hpp"

namespace goishi::cli {

namespace {

const char* touched_by(const Board<double>& board, const std::optional<StoneId>& other, const Vec3<double>& p_WC,
                       OtherFeature feature) {
  return other ? "stone" : is_on_floor(board, p_WC, feature) ? "floor" : "board";
}

}  // namespace

SceneJson::SceneJson(const SceneFile& file) : file_(file) {
  json_.member("title", file.title);
  json_.begin_array("events");
}

void SceneJson::tell(const ScenePlay& play, const SceneEvent<double>& told) {
  json_.begin_object();
  json_.count("stone", static_cast<long long>(index_of(told.stone)));
  if (told.other) {
    json_.count("other", static_cast<long long>(index_of(*told.other)));
  }
  const Event<double>& event = told.event;
  write_event(json_, event, play.solid(told.stone).body, play.scene().settings().drop.gravity,
              touched_by(file_.board, told.other, event.contact_W, event.other_feature));
  json_.end_object();
}

std::string SceneJson::text(const ScenePlay& end, bool rests) {
  const Scene<double>& scene = end.scene();
  json_.end_array();
  json_.begin_object("final");
  json_.member("status", rests ? "rest" : "moving");
  json_.member("time", scene.time());
  json_.member("energy", scene.energy());
  json_.member("hand_work", end.hand_work());
  json_.begin_array("stones");
  for (const StoneId id : scene.stones()) {
    json_.begin_object();
    json_.count("stone", static_cast<long long>(index_of(id)));
    json_.member("mode", to_string(scene.mode(id)));
    write_sample(json_, sample_of(scene.time(), scene.state(id), scene.body(id), scene.settings().drop.gravity));
    json_.end_object();
  }
  json_.end_array();
  json_.begin_array("contacts");
  for (const SceneContact<double>& contact : scene.contacts()) {
    json_.begin_object();
    json_.count("stone", static_cast<long long>(index_of(contact.stone)));
    if (contact.other) {
      json_.count("other", static_cast<long long>(index_of(*contact.other)));
    }
    json_.member("touched", touched_by(file_.board, contact.other, contact.p_WC, OtherFeature::surface));
    json_.member("contact_point", contact.p_WC);
    json_.member("normal", contact.n_W);
    json_.member("force", contact.force_W);
    json_.end_object();
  }
  json_.end_array();
  json_.begin_object("counters");
  for (const auto& [name, count] : counts_of(scene.counters())) {
    json_.count(name, count);
  }
  json_.end_object();
  json_.end_object();
  return json_.text();
}

}  // namespace goishi::cli
