package org.palpate.app.output;

import java.io.PrintWriter;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import org.palpate.frame.FrameStatistics;
import org.palpate.host.ToolReplay;
import org.palpate.io.file.CountText;
import org.palpate.tool.MadeTool;

/** Reports a rigid tool and the results of its frames. One thread. */
public final class ToolReport {
  /** The solver of every rigid tool, in reports. */
  public static final String SOLVER = "rigid";

  /** The collision method of every rigid tool, in reports. */
  public static final String COLLISION = "exact";

  private final MadeTool made;
  private final OptionalDouble massKg;

  /**
   * Creates a report of a tool.
   *
   * @param massKg the mass that the user stated, if any
   */
  public ToolReport(MadeTool made, OptionalDouble massKg) {
    this.made = made;
    this.massKg = massKg;
  }

  /** Returns the name of a tool and the number of its points, for a line of text. */
  public static String line(MadeTool made) {
    return "tool " + made.name() + " of " + CountText.of(made.tool().count(), "point");
  }

  /** Prints a summary of a replay. */
  public void print(ToolReplay.Result result, PrintWriter out) {
    FrameStatistics counts = result.statistics();
    out.println(
        String.format(
            Locale.ROOT,
            "%,d frames, %,d in contact, set free %,d times, largest force %.3f N, largest torque"
                + " %.3f N mm (%s, %s)",
            counts.frames(),
            counts.contactFrames(),
            counts.freed(),
            counts.maxForceNewton(),
            counts.maxTorqueNewtonMm(),
            made.name(),
            CountText.of(made.tool().count(), "point")));
    ToolReplay.MovedBodies bodies = result.bodies();
    if (bodies.movable() > 0) {
      out.println(moved(bodies));
    }
  }

  /** Returns how bodies moved that were not in the hand, as a line. */
  static String moved(ToolReplay.MovedBodies bodies) {
    return "outside the hand: "
        + CountText.of(bodies.motions(), "motion")
        + " of "
        + CountText.of(bodies.movable(), "movable body", "movable bodies")
        + ", "
        + CountText.of(bodies.pushes(), "push", "pushes")
        + " of the tool, held back "
        + CountText.of(bodies.heldBack(), "time");
  }

  /** Adds the fields of a replay to a report. */
  public void putInto(Report report, ToolReplay.Result result) {
    FrameStatistics counts = result.statistics();
    report
        .put("frames", counts.frames())
        .put("contact_frames", counts.contactFrames())
        .put("freed", counts.freed())
        .put("max_force_n", counts.maxForceNewton())
        .put("max_torque_nmm", counts.maxTorqueNewtonMm())
        .put("solver", SOLVER)
        .put("collision", COLLISION)
        .put("tool", tool(result.mostReduced()))
        .put("work", WorkFields.of(result.work()))
        .put("skipped", counts.skipped())
        .put("faults", FaultFields.ofTool(counts.faults()));
    if (result.bodies().movable() > 0) {
      report.put("moving", moving(result.bodies()));
    }
  }

  private static Map<String, Object> moving(ToolReplay.MovedBodies bodies) {
    Map<String, Object> fields = new LinkedHashMap<>();
    fields.put("bodies", bodies.movable());
    fields.put("motions", bodies.motions());
    fields.put("pushes", bodies.pushes());
    fields.put("held_back", bodies.heldBack());
    fields.put("elsewhere", bodies.elsewhere());
    return fields;
  }

  /**
   * Returns the fields of the tool itself.
   *
   * @param mostReduced the most points that kept less than their clearance in any frame
   */
  public Map<String, Object> tool(int mostReduced) {
    Map<String, Object> fields = new LinkedHashMap<>();
    fields.put("spec", made.name());
    fields.put("points", made.tool().count());
    made.clearanceMm()
        .ifPresent(
            mm -> {
              fields.put("clearance_mm", mm);
              fields.put("clearance_reduced", mostReduced);
            });
    massKg.ifPresent(kg -> fields.put("mass_kg", kg));
    return fields;
  }
}
