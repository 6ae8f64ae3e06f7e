#include "gradebook/run/class_run.hpp"

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>

#include "gradebook/run/record_names.hpp"
#include "gradebook/run/worker_pool.hpp"

namespace cs550::gradebook {
namespace {

/// A lab's files, graded once for all submissions that contain exactly these.
struct Task {
  std::string key;
  CatalogueLab lab;
  LabFiles files;
  LabRecord result;
  bool is_done = false;
  std::string graded_for;  ///< the first record with these files
};

using Tasks = std::map<std::string, std::shared_ptr<Task>>;

/// A record that waits for its labs.
struct Draft {
  Record record;
  /// By lab, and 0 for the engine; none where nothing was submitted.
  std::map<int, std::shared_ptr<Task>> tasks;
  bool is_stored = false;

  bool is_complete() const {
    return std::all_of(tasks.begin(), tasks.end(),
                       [](const auto& task) { return task.second->is_done; });
  }
};

Record begin_record(const Submission& submission, const std::string& project) {
  Record record;
  record.name = submission.name;
  record.source = submission.source;
  record.path = submission.path;
  record.folders = submission.folders;
  record.student = submission.student;
  record.is_identified = submission.is_identified;
  record.claimed_student = submission.claimed_student;
  record.claimed_date = submission.claimed_date;
  record.starter = submission.starter;
  record.file_time = submission.file_time;
  record.hash = submission.hash();
  record.project = project;
  record.ignored = submission.ignored;
  record.trouble = submission.trouble;
  return record;
}

LabRecord lab_record(const Task& task, const std::string& hash, const std::string& name) {
  LabRecord lab = task.result;
  if (name != task.graded_for) lab.same_as = task.graded_for;
  lab.submitted = true;
  lab.hash = hash;
  lab.supplied = task.files.supplied;
  for (const SourceFile& file : task.files.files) lab.files.push_back(file.path);
  return lab;
}

/// The N up to which labs 1 to N are there.
int last_lab(const std::function<bool(int)>& is_there) {
  int last = 0;
  while (is_there(last + 1)) ++last;
  return last;
}

/// Replaces the milestones that were run.
void take_milestones(const LabRecord& ran, LabRecord& engine) {
  LabRecord taken = ran;
  taken.submitted = true;
  taken.tests = engine.tests;
  for (TestResult& milestone : taken.tests) {
    for (const TestResult& test : ran.tests) {
      if (test.name == milestone.name) milestone = test;
    }
  }
  engine = std::move(taken);
}

/// The state of a run.
class Run {
 public:
  Run(const ClassRun& run, const Catalogue& catalogue, const Course& course, const Judge& judge,
      const RecordFolder& folder, const std::atomic<bool>& stop)
      : run_(run),
        catalogue_(catalogue),
        course_(course),
        judge_(judge),
        folder_(folder),
        stop_(stop) {}

  ClassOutcome operator()() {
    read_submissions();
    grade_tasks();
    store_complete();
    outcome_.interrupted = stop_;
    outcome_.submissions = static_cast<int>(
        std::count_if(drafts_.begin(), drafts_.end(), [](const Draft& d) { return d.is_stored; }));
    return outcome_;
  }

 private:
  void read_submissions() {
    RecordNames names(folder_.records(), run_.submissions);
    for (const FoundSubmission& found : run_.submissions) {
      if (stop_) return;
      Submission submission = read_submission(found, catalogue_);
      submission.name = names.name_for(submission);
      Draft draft{begin_record(submission, judge_.project), {}, false};
      for (const int number : run_.labs) {
        const CatalogueLab& lab = catalogue_.at(number);
        draft.record.labs.push_back(not_submitted(lab));
        if (!submission.labs.contains(number)) continue;
        draft.record.labs.back().hash = submission.lab_hash(number);
        draft.tasks[number] =
            task_for(draft.record.name, lab, files_to_grade(submission, lab, judge_.starters));
      }
      add_engine(submission, draft);
      drafts_.push_back(std::move(draft));
    }
  }

  /// Milestones of labs that are graded, but not submitted, are in the record too.
  void add_engine(const Submission& submission, Draft& draft) {
    if (!run_.milestones) return;
    const int graded = last_lab(
        [this](int lab) { return std::count(run_.labs.begin(), run_.labs.end(), lab) > 0; });
    const int submitted =
        std::min(graded, last_lab([&](int lab) { return submission.labs.contains(lab); }));
    if (graded > 0) draft.record.engine = not_submitted(engine_of(catalogue_, graded));
    if (submitted == 0) return;
    const CatalogueLab engine = engine_of(catalogue_, submitted);
    draft.tasks[0] = task_for(draft.record.name, engine,
                              files_of_engine(submission, catalogue_, engine, judge_.starters));
  }

  std::shared_ptr<Task> task_for(const std::string& name, const CatalogueLab& lab, LabFiles files) {
    const std::string key = result_key(lab.number, files, course_, judge_);
    std::shared_ptr<Task>& task = tasks_[key];
    if (task) {
      ++outcome_.known;
      return task;
    }
    task = std::make_shared<Task>(Task{key, lab, std::move(files), {}, false, name});
    if (const std::optional<LabRecord> known = folder_.result(key); known && known->is_final()) {
      task->result = *known;
      task->is_done = true;
      ++outcome_.known;
    }
    return task;
  }

  static int length(const CatalogueLab& lab) { return std::max(lab.number, lab.last); }

  /// Labs with a high number take longest, and what takes longest is begun first.
  std::vector<std::shared_ptr<Task>> open_tasks() const {
    std::vector<std::shared_ptr<Task>> open;
    for (const auto& [key, task] : tasks_) {
      if (!task->is_done) open.push_back(task);
    }
    std::stable_sort(open.begin(), open.end(),
                     [](const auto& a, const auto& b) { return length(a->lab) > length(b->lab); });
    return open;
  }

  void grade_tasks() {
    const std::vector<std::shared_ptr<Task>> open = open_tasks();
    const int total = static_cast<int>(open.size());
    WorkerPool pool(
        run_.jobs, open.size(), [&](std::size_t i) { grade(*open[i]); }, stop_);
    while (pool.is_busy()) {
      for (const std::size_t i : pool.wait_for_finished()) {
        open[i]->is_done = true;
        ++outcome_.runs;
      }
      store_complete();
      if (run_.on_progress) run_.on_progress(outcome_.runs, total);
    }
  }

  void grade(Task& task) const {
    task.result = grade_lab(task.lab, task.files, course_, judge_, stop_);
    if (!stop_ && task.result.is_final()) folder_.store_result(task.key, task.result);
  }

  void store_complete() {
    if (stop_) return;
    for (Draft& draft : drafts_) {
      if (draft.is_stored || !draft.is_complete()) continue;
      for (LabRecord& lab : draft.record.labs) {
        const auto task = draft.tasks.find(lab.lab);
        if (task != draft.tasks.end()) lab = lab_record(*task->second, lab.hash, draft.record.name);
      }
      if (const auto engine = draft.tasks.find(0); engine != draft.tasks.end()) {
        take_milestones(engine->second->result, *draft.record.engine);
      }
      folder_.store(draft.record);
      draft.is_stored = true;
    }
  }

  const ClassRun& run_;
  const Catalogue& catalogue_;
  const Course& course_;
  const Judge& judge_;
  const RecordFolder& folder_;
  const std::atomic<bool>& stop_;
  std::vector<Draft> drafts_;
  Tasks tasks_;
  ClassOutcome outcome_;
};

}  // namespace

ClassOutcome grade_class(const ClassRun& run, const Catalogue& catalogue, const Course& course,
                         const Judge& judge, const RecordFolder& folder,
                         const std::atomic<bool>& stop) {
  return Run(run, catalogue, course, judge, folder, stop)();
}

}  // namespace cs550::gradebook
