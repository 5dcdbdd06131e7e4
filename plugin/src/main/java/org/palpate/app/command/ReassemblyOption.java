package org.palpate.app.command;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import org.palpate.app.options.NumberRange;
import org.palpate.app.process.PalpateException;
import org.palpate.app.process.ProgressLine;
import org.palpate.body.Mobility;
import org.palpate.fracture.fit.FaceFit;
import org.palpate.fracture.fit.Reassembly;
import org.palpate.io.scene.PlacedVolume;
import org.palpate.volume.Segment;
import picocli.CommandLine.Option;

/** The option that proposes a pose for each fragment of a scene. */
final class ReassemblyOption {
  private static final String NAME = "--fit";

  private static final NumberRange GAP =
      new NumberRange(NAME, "the width of the gap", 0, FaceFit.MOST_GAP_MM, "mm", "0");

  @Option(
      names = NAME,
      paramLabel = "GAP",
      description = {
        "Proposes a pose for each movable body of a scene, at which its fracture face fits to that"
            + " of another within 60 mm and 75 degrees, some seconds for each pair. --save-scene"
            + " and --save-transforms write the proposals. GAP is the width of a saw cut in mm, 0"
            + " for none."
      })
  private Double gapMm;

  /**
   * Checks the width of the gap.
   *
   * @throws PalpateException exit code 2, if it is out of range
   */
  void checkGap() {
    GAP.checkGiven(gapMm);
  }

  /**
   * Checks the option against the volume.
   *
   * @param hasBodies whether there are bodies with poses
   * @throws PalpateException exit code 2, if there is nothing to fit
   */
  void check(boolean hasBodies) {
    if (gapMm != null && !hasBodies) {
      throw PalpateException.wrongUse(
          "there are no fragments to fit",
          NAME,
          "leave it out, or choose --scene FILE.json or --phantom fracture");
    }
  }

  /**
   * Returns the bodies where they are proposed to be.
   *
   * @param bodies where they are
   * @param line receives a line for each fragment, also for one that nothing fits to
   * @return empty if no proposal is wanted
   */
  Optional<PlacedVolume> propose(Optional<PlacedVolume> bodies, Consumer<String> line) {
    return gapMm == null ? Optional.empty() : bodies.map(all -> propose(all, line));
  }

  private PlacedVolume propose(PlacedVolume bodies, Consumer<String> line) {
    List<Segment> segments = bodies.rest().segments();
    Reassembly reassembly =
        new Reassembly(
            bodies.rest().grids(),
            segments.stream().map(Segment::bits).toList(),
            gapMm,
            bodies.poses(),
            n -> bodies.placements().get(n).mobility() != Mobility.MOVABLE);
    ProgressLine bar = new ProgressLine("fitting");
    reassembly.onProgress(bar::slicesRead);
    Optional<Reassembly.Joint> joint = reassembly.add();
    while (joint.isPresent()) {
      bar.clear();
      line.accept(text(joint.get(), segments));
      joint = reassembly.add();
    }
    bar.clear();
    for (int left : reassembly.left()) {
      line.accept(
          segments.get(left).name()
              + ": none, because no pose that was tried has more area for it than against it;"
              + " it stays where it is");
    }
    return bodies.at(reassembly.poses());
  }

  private static String text(Reassembly.Joint joint, List<Segment> segments) {
    return String.format(
        Locale.ROOT,
        "%s to %s: score %.0f mm^2, %.0f at the best other place%s",
        segments.get(joint.fragment()).name(),
        segments.get(joint.other()).name(),
        joint.scoreMm2(),
        joint.nextScoreMm2(),
        joint.isUncertain() ? "; uncertain, check it by eye" : "");
  }
}
