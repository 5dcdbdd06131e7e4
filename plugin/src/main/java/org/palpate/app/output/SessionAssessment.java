package org.palpate.app.output;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.palpate.app.options.AssessOptions;
import org.palpate.assess.SessionAssessor;
import org.palpate.assess.SessionCourse;
import org.palpate.assess.TremorSpectrum;
import org.palpate.frame.FrameObserver;
import org.palpate.geometry.Vec3;
import org.palpate.host.ContactScene;
import org.palpate.io.file.AtomicFile;
import org.palpate.io.table.CsvWriter;
import org.palpate.io.table.ReportJson;
import org.palpate.recording.FrameRecorder;
import org.palpate.volume.Segment;

/**
 * The assessment of a session, live or replayed. The haptic thread puts its frames into a ring
 * buffer, and one other thread takes them out and writes the files.
 *
 * <p>The files name segments and nothing else of the input, so that no name of a patient can come
 * from the name of a file.
 */
public final class SessionAssessment {
  /** The name of the margins around protected segments, which a point touches as one object. */
  private static final String MARGINS = "margins of protected segments";

  private final Path folder;
  private final ContactScene scene;
  private final boolean isRigid;

  /** Whether a device or an option limits the forces. */
  private boolean isLimited = true;

  private final List<String> objects = new ArrayList<>();
  private final Set<Integer> forbidden = new TreeSet<>();
  private final FrameRecorder ring = new FrameRecorder();
  private final SessionAssessor assessor;

  private static final String WITHOUT_LIMIT =
      "Forces have no limit, because a replay knows no device; --max-force sets one.";

  /** Writes one file of the assessment. */
  private interface Content {
    void write(OutputStream stream) throws IOException;
  }

  /**
   * Creates an assessment of no frame.
   *
   * @param folder receives the files; it need not exist yet
   * @param isRigid whether the hand holds a rigid tool
   */
  public SessionAssessment(Path folder, ContactScene scene, boolean isRigid) {
    this.folder = folder;
    this.scene = scene;
    this.isRigid = isRigid;
    for (Segment segment : scene.volume().segments()) {
      if (scene.settings().protectedMm().containsKey(segment.name())) {
        forbidden.add(objects.size());
      }
      objects.add(segment.name());
    }
    if (scene.protectedVoxels().isPresent() && !isRigid) {
      forbidden.add(objects.size());
      objects.add(MARGINS);
    }
    assessor = new SessionAssessor(objects.size(), forbidden);
  }

  /**
   * Returns the observer for the frames of a live session. Its ring buffer fills, so another thread
   * calls {@link #drain} many times a second.
   */
  public FrameObserver live() {
    return ring;
  }

  /** Returns the observer for the frames of a replay. No call of {@link #drain} is needed. */
  public FrameObserver replayed() {
    isLimited = scene.settings().maxForceNewton().isPresent();
    return frame -> {
      ring.accept(frame);
      drain();
    };
  }

  /** Takes all frames out of the ring buffer and assesses them. */
  public void drain() {
    ring.drainTo(assessor);
  }

  /**
   * Writes the files after the last frame.
   *
   * @param report the fields of the session's report, of which some belong to an assessment
   */
  public void write(Map<String, Object> report, WriteFailures failures) {
    drain();
    assessor.finish();
    AssessmentValues values =
        new AssessmentValues(assessor, objects, forbidden, ring.overflows(), report);
    values.putLimited(isLimited);
    AssessmentPage page = new AssessmentPage(assessor, values, this::world);
    if (!isLimited) {
      page.noteAboutForce(WITHOUT_LIMIT);
    }
    write(failures, AssessOptions.VALUES, file -> ReportJson.write(values.fields(), file));
    write(failures, AssessOptions.SEGMENTS, file -> table(file, values.segments()));
    write(failures, AssessOptions.HOLDS, file -> table(file, values.holds()));
    write(failures, AssessOptions.COURSE, this::writeCourse);
    write(failures, AssessOptions.TREMOR, this::writeTremor);
    write(
        failures,
        AssessOptions.PAGE,
        file -> file.write(page.text().getBytes(StandardCharsets.UTF_8)));
  }

  private void write(WriteFailures failures, String name, Content content) {
    Path target = folder.resolve(name);
    failures.attempt(
        target,
        () -> {
          Files.createDirectories(folder);
          try (AtomicFile file = new AtomicFile(target)) {
            content.write(file.stream());
            file.commit();
          }
        });
  }

  private static void table(OutputStream file, AssessmentValues.Table table) throws IOException {
    CsvWriter rows = new CsvWriter(file, String.join(",", table.columns()));
    for (Map<String, Object> row : table.rows()) {
      for (String column : table.columns()) {
        Object value = row.get(column);
        if (value instanceof Double number) {
          rows.cell(number);
        } else if (value instanceof Long number) {
          rows.cell(number);
        } else {
          rows.cell(value.toString());
        }
      }
      rows.end();
    }
  }

  private void writeCourse(OutputStream file) throws IOException {
    CsvWriter rows = new CsvWriter(file, "t_s,max_force_n,mean_force_n,contact,forbidden,x,y,z");
    SessionCourse course = assessor.course();
    Vec3 position = new Vec3();
    for (int row = 0; row < course.rows(); row++) {
      if (course.hasFrames(row)) {
        world(course.positionMm(row, position));
        rows.cell(course.seconds(row)).cell(course.largestNewton(row)).cell(course.meanNewton(row));
        rows.cell(course.contact(row)).cell(course.forbidden(row));
        rows.cell(position.x).cell(position.y).cell(position.z).end();
      }
    }
  }

  private void writeTremor(OutputStream file) throws IOException {
    CsvWriter rows = new CsvWriter(file, "hz,density_mm2_per_hz");
    TremorSpectrum tremor = assessor.tremor();
    for (int line = 1; line <= tremor.lines(); line++) {
      rows.cell(tremor.hertz(line)).cell(tremor.density(line)).end();
    }
  }

  /** Changes a position of a record into world mm; that of a point is along the grid's axes. */
  private Vec3 world(Vec3 positionMm) {
    if (!isRigid) {
      Vec3 spacing = scene.grid().spacingMm();
      positionMm.set(positionMm.x / spacing.x, positionMm.y / spacing.y, positionMm.z / spacing.z);
      scene.grid().gridToWorld(positionMm, positionMm);
    }
    return positionMm;
  }
}
