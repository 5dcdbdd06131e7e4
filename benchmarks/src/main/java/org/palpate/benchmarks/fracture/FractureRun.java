package org.palpate.benchmarks.fracture;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.palpate.benchmarks.report.MachineSummary;
import org.palpate.benchmarks.report.Progress;
import org.palpate.benchmarks.report.StudyTable;
import org.palpate.benchmarks.rigid.RigidFigure;
import org.palpate.benchmarks.rigid.RigidRun;

/** Runs the study of broken bones, prints its figures, and writes a table. */
public final class FractureRun {
  private static final int FRACTURES = 3;

  private FractureRun() {}

  /**
   * Runs the study on tubes and on the jaw of the scan CThead, in 4 and 8 parts.
   *
   * @param data the folder of the scans; without it the phantom's arch takes the place of the jaw
   * @param folder the output folder, created if missing
   * @param quick whether to break each bone once
   * @param seed of the first fracture
   * @param out receives the figures
   * @param progress receives progress lines
   * @return the number of figures that miss their targets
   */
  public static long run(
      Path data, Path folder, boolean quick, long seed, PrintWriter out, PrintWriter progress)
      throws IOException {
    Files.createDirectories(folder);
    out.println(MachineSummary.line(MachineSummary.facts()) + ", seed " + seed);
    List<WholeBone> bones = new ArrayList<>(List.of(WholeBone.tube()));
    bones.add(Files.isDirectory(data) ? WholeBone.jaw(data) : WholeBone.arch());
    ReductionStudy study = new ReductionStudy(seed, quick ? 1 : FRACTURES, Progress.to(progress));
    List<RigidFigure> figures = new ArrayList<>();
    for (WholeBone bone : bones) {
      for (int parts : new int[] {4, 8}) {
        for (Contact contact : Contact.values()) {
          List<RigidFigure> found = study.figures(bone, parts, contact);
          RigidRun.print(found, out);
          figures.addAll(found);
        }
      }
    }
    StudyTable.FRACTURE.write(folder, figures, RigidFigure::cells);
    return RigidRun.printMissed(figures, out);
  }
}
