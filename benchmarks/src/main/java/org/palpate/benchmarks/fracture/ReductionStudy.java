package org.palpate.benchmarks.fracture;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.ToDoubleFunction;
import org.palpate.benchmarks.fracture.PutBack.Outcome;
import org.palpate.benchmarks.rigid.RigidFigure;
import org.palpate.fracture.Residual;
import org.palpate.volume.fracture.FractureSpec;

/** Breaks a bone again and again, and measures how well a simulated hand puts it together. */
final class ReductionStudy {
  /** The share of fragments that may be out of place, percent. */
  private static final double MOST_PERCENT = 5;

  /** The most seeds that are tried for each fracture: some leave a fragment too small. */
  private static final int TRIES = 5;

  private final long firstSeed;
  private final int fractures;
  private final Consumer<String> progress;

  /**
   * Creates a study.
   *
   * @param firstSeed the seed of the first fracture; each further one has the next
   * @param fractures the number of fractures for each condition
   */
  ReductionStudy(long firstSeed, int fractures, Consumer<String> progress) {
    this.firstSeed = firstSeed;
    this.fractures = fractures;
    this.progress = progress;
  }

  /** Returns the figures of a bone that breaks into some parts. */
  List<RigidFigure> figures(WholeBone bone, int parts, Contact contact) {
    String condition = bone.name() + ", " + parts + " parts, " + contact;
    List<PutBack> all = new ArrayList<>();
    int done = 0;
    long frames = 0;
    for (int n = 0; n < TRIES * fractures && done < fractures; n++) {
      FractureSpec fracture = new FractureSpec(parts, firstSeed + n, contact.kerfVoxels());
      Optional<BrokenBone> broken = broken(bone, fracture);
      if (broken.isPresent()) {
        Reduction reduction = Reduction.of(broken.get(), contact, fracture.seed());
        all.addAll(reduction.parts());
        frames += reduction.frames();
        done++;
        progress.accept(condition + ", fracture " + fracture + ": " + reduction.parts());
      }
    }
    return figures(condition, all, done, frames);
  }

  private Optional<BrokenBone> broken(WholeBone bone, FractureSpec fracture) {
    try {
      return Optional.of(BrokenBone.of(bone, fracture));
    } catch (IllegalArgumentException e) {
      progress.accept(bone.name() + ", fracture " + fracture + " is left out: " + e.getMessage());
      return Optional.empty();
    }
  }

  private static List<RigidFigure> figures(
      String condition, List<PutBack> all, int done, long frames) {
    double[] mm = sorted(all, Residual::distanceMm);
    double[] degrees = sorted(all, Residual::angleDegrees);
    double count = all.size();
    double out = count - count(all, Outcome.IN_PLACE);
    return List.of(
        of(condition, "fractures", done, ""),
        of(condition, "fragments", count, ""),
        of(condition, "fragments not taken", count(all, Outcome.NOT_TAKEN), ""),
        of(condition, "fragments without a way", count(all, Outcome.NO_WAY), ""),
        of(condition, "fragments that did not arrive", count(all, Outcome.ASIDE), ""),
        of(condition, "fragments left beside their place", count(all, Outcome.BESIDE), ""),
        new RigidFigure(
            "reduction", condition, "fragments out of place", 100 * out / count, "%", MOST_PERCENT),
        of(condition, "displacement p50", mm[mm.length / 2], "mm"),
        of(condition, "displacement max", mm[mm.length - 1], "mm"),
        of(condition, "angle p50", degrees[degrees.length / 2], "deg"),
        of(condition, "angle max", degrees[degrees.length - 1], "deg"),
        of(condition, "frames for each fragment", frames / count, ""));
  }

  private static double count(List<PutBack> all, Outcome outcome) {
    return all.stream().filter(part -> part.outcome() == outcome).count();
  }

  private static double[] sorted(List<PutBack> all, ToDoubleFunction<Residual> value) {
    double[] values = all.stream().map(PutBack::residual).mapToDouble(value).toArray();
    Arrays.sort(values);
    return values;
  }

  private static RigidFigure of(String condition, String name, double value, String unit) {
    return RigidFigure.of("reduction", condition, name, value, unit);
  }
}
