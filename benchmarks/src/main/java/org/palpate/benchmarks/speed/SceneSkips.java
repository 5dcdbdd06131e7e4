package org.palpate.benchmarks.speed;

import com.sun.management.OperatingSystemMXBean;
import java.io.PrintWriter;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeoutException;
import org.palpate.geometry.Vec3;
import org.palpate.scene.SceneLoader;
import org.palpate.scene.SceneModel;
import org.palpate.scene.StandardView;
import org.palpate.scene.Theme;
import org.palpate.scene.TouchMarks;
import org.palpate.scene.WorldAxes;
import org.palpate.scene.gl.SceneRendererVariants;
import org.palpate.scene.window.GraphicsException;
import org.palpate.scene.window.OffscreenRenderer;
import org.palpate.scene.window.OffscreenRendererVariants;
import org.palpate.volume.phantom.Phantom;

/**
 * The gain of the scene's skips: processor time of a redraw with and without each, in alternation.
 * The time is that of all threads, because a software renderer has threads of its own.
 *
 * <ul>
 *   <li>{@code nodes not seen}: bricks of surfaces outside the view; helps if a near camera moves,
 *       not if it sees everything.
 *   <li>{@code nodes unchanged}: the picture of everything at rest is kept; helps if only the hand
 *       moves, not if the camera does.
 * </ul>
 */
final class SceneSkips {
  private static final int WIDTH = 640;
  private static final int HEIGHT = 480;
  private static final int WARM_UP_ROUNDS = 1;

  /** Averages over the resolution of the process clock, which is 10 ms. */
  private static final int PICTURES_PER_ROUND = 10;

  private static final long PATIENCE_MS = 600_000;
  private static final double NEARER = 0.12;
  private static final double MOVE_RADIANS = 0.002;

  private final int rounds;
  private final String phantom;
  private final OperatingSystemMXBean process =
      ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);

  SceneSkips(boolean quick) {
    rounds = quick ? 3 : 7;
    phantom = quick ? "head:128" : "head:256";
  }

  /** Measures all rows; if this machine cannot draw, prints the reason and returns none. */
  List<SpeedRow> rows(PrintWriter out) {
    SceneModel model = new SceneModel(WorldAxes.UNKNOWN, Theme.DARK);
    try (SceneLoader loader = new SceneLoader(model, Phantom.parse(phantom).segments(), 1);
        OffscreenRenderer both = renderer(true, true);
        OffscreenRenderer drawsUnseen = renderer(false, true);
        OffscreenRenderer drawsUnchanged = renderer(true, false)) {
      loader.await(PATIENCE_MS);
      List<SpeedRow> rows = new ArrayList<>();
      rows.addAll(compare(both, drawsUnseen, model, "nodes not seen", true));
      rows.addAll(compare(both, drawsUnseen, model, "nodes not seen", false));
      rows.addAll(compare(both, drawsUnchanged, model, "nodes unchanged", true));
      rows.addAll(compare(both, drawsUnchanged, model, "nodes unchanged", false));
      return rows;
    } catch (GraphicsException e) {
      out.println("the skips of the scene were not measured: " + e.what() + ": " + e.remedy());
      return List.of();
    } catch (TimeoutException e) {
      throw new IllegalStateException("the surface was not made", e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return List.of();
    }
  }

  private static OffscreenRenderer renderer(boolean cullsOutsideView, boolean reusesStatic)
      throws GraphicsException {
    return OffscreenRendererVariants.of(
        WIDTH, HEIGHT, SceneRendererVariants.of(cullsOutsideView, reusesStatic));
  }

  private List<SpeedRow> compare(
      OffscreenRenderer skipping,
      OffscreenRenderer drawingAll,
      SceneModel model,
      String skip,
      boolean helps) {
    boolean isUnseen = skip.equals("nodes not seen");
    boolean moves = isUnseen || !helps;
    model.look(StandardView.OBLIQUE, (double) WIDTH / HEIGHT);
    if (isUnseen && helps) {
      model.moveCamera(camera -> camera.zoom(NEARER), false);
    }
    List<Double> with = new ArrayList<>();
    List<Double> without = new ArrayList<>();
    for (int round = -WARM_UP_ROUNDS; round < rounds; round++) {
      for (boolean on : new boolean[] {true, false}) {
        double millis = millisPerPicture(on ? skipping : drawingAll, model, moves);
        if (round >= 0) {
          (on ? with : without).add(millis);
        }
      }
    }
    return List.of(row(skip, helps, "with", with), row(skip, helps, "without", without));
  }

  /** Moves the camera back and forth, or only the hand. */
  private static void change(SceneModel model, boolean camera, int n) {
    if (camera) {
      model.moveCamera(now -> now.orbit((n & 1) == 0 ? MOVE_RADIANS : -MOVE_RADIANS, 0), false);
    } else {
      Vec3 at = new Vec3(n, n, n);
      model.setMarks(Optional.of(new TouchMarks(at, at, new Vec3(0, 0, 1), true, List.of())));
    }
  }

  private double millisPerPicture(OffscreenRenderer picture, SceneModel model, boolean moves) {
    long began = process.getProcessCpuTime();
    for (int n = 0; n < PICTURES_PER_ROUND; n++) {
      change(model, moves, n);
      picture.draw(model.state());
    }
    return (process.getProcessCpuTime() - began) / (1e6 * PICTURES_PER_ROUND);
  }

  private static SpeedRow row(String skip, boolean helps, String variant, List<Double> millis) {
    Collections.sort(millis);
    Map<String, String> condition = new LinkedHashMap<>();
    condition.put("skip", skip);
    condition.put("scene", helps ? "helps" : "does not help");
    condition.put("way", variant);
    return new SpeedRow("skips", "redraw", condition, "ms/op", millis, Double.NaN);
  }
}
