package org.palpate.host;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.palpate.device.DeviceSpecification;
import org.palpate.elastic.ElasticBody;
import org.palpate.loop.LoopEnd;
import org.palpate.loop.LoopSettings;
import org.palpate.recording.BodyRecorder;
import org.palpate.recording.EditRecorder;
import org.palpate.recording.FieldRecorder;
import org.palpate.recording.SampleRecorder;

/**
 * Settings of a {@link TouchSession} beside its scene and its device.
 *
 * <p>Immutable. Start from {@link #standard()}.
 *
 * @param defaultNewtonPerMm stiffness if the scene's settings give none, N per mm of scan; if
 *     empty, the smaller of {@link ContactScene#defaultStiffnessNewtonPerMm} and {@link
 *     DeviceSpecification#defaultStiffnessNewtonPerMm}
 * @param loop pace and thread setup; the session adds the warm-up
 * @param recorder records what the device sends, if given
 * @param editRecorder records changes of voxels, if given
 * @param bodyRecorder records poses of bodies, if given
 * @param fieldRecorder records updates of elastic segments, if given
 * @param elastic makes the elastic segments at rest, if there are any; for a point alone
 * @param listener receives the end of the loop, once, on the thread that ends it
 */
public record SessionSettings(
    OptionalDouble defaultNewtonPerMm,
    LoopSettings loop,
    Optional<SampleRecorder> recorder,
    Optional<EditRecorder> editRecorder,
    Optional<BodyRecorder> bodyRecorder,
    Optional<FieldRecorder> fieldRecorder,
    Optional<Supplier<ElasticBody>> elastic,
    Consumer<LoopEnd> listener) {
  private static final double USUAL_HERTZ = 1000;

  /** {@return the default settings: 1,000 frames a second, no recorder and no listener} */
  public static SessionSettings standard() {
    return new SessionSettings(
        OptionalDouble.empty(),
        LoopSettings.ofRate(USUAL_HERTZ),
        Optional.empty(),
        Optional.empty(),
        Optional.empty(),
        Optional.empty(),
        Optional.empty(),
        end -> {});
  }

  /**
   * {@return a copy with the stiffness that is used if the scene's settings give none}
   *
   * @param newtonPerMm the stiffness, N per mm of scan
   */
  public SessionSettings withDefaultStiffness(double newtonPerMm) {
    return copy(draft -> draft.defaultNewtonPerMm = OptionalDouble.of(newtonPerMm));
  }

  /**
   * {@return a copy with another pace and thread setup}
   *
   * @param newLoop pace, pacer and thread setup of the haptic thread
   */
  public SessionSettings withLoop(LoopSettings newLoop) {
    return copy(draft -> draft.loop = newLoop);
  }

  /**
   * {@return a copy that records what the device sends, if a recorder is given}
   *
   * @param newRecorder receives the samples; empty to record nothing
   */
  public SessionSettings withRecorder(Optional<SampleRecorder> newRecorder) {
    return copy(draft -> draft.recorder = newRecorder);
  }

  /**
   * {@return a copy that records changes of voxels, if a recorder is given}
   *
   * @param newRecorder receives the changes; empty to record nothing
   */
  public SessionSettings withEditRecorder(Optional<EditRecorder> newRecorder) {
    return copy(draft -> draft.editRecorder = newRecorder);
  }

  /**
   * {@return a copy that records poses of bodies, if a recorder is given}
   *
   * @param newRecorder receives the poses; empty to record nothing
   */
  public SessionSettings withBodyRecorder(Optional<BodyRecorder> newRecorder) {
    return copy(draft -> draft.bodyRecorder = newRecorder);
  }

  /**
   * {@return a copy that records updates of elastic segments, if a recorder is given}
   *
   * @param newRecorder receives the updates; empty to record nothing
   */
  public SessionSettings withFieldRecorder(Optional<FieldRecorder> newRecorder) {
    return copy(draft -> draft.fieldRecorder = newRecorder);
  }

  /**
   * {@return a copy with elastic segments, if they are given}
   *
   * @param bodies makes elastic segments at rest, for the session and for its warm-up; empty for
   *     none
   */
  public SessionSettings withElastic(Optional<Supplier<ElasticBody>> bodies) {
    return copy(draft -> draft.elastic = bodies);
  }

  /**
   * {@return a copy that reports the end of the loop, once, on the thread that ends it}
   *
   * @param newListener receives how the loop ended
   */
  public SessionSettings withListener(Consumer<LoopEnd> newListener) {
    return copy(draft -> draft.listener = newListener);
  }

  /** Returns the stiffness if the scene's settings give none, N per mm of scan. */
  double defaultNewtonPerMm(ContactScene scene, DeviceSpecification device) {
    return defaultNewtonPerMm.orElseGet(
        () -> Math.min(scene.defaultStiffnessNewtonPerMm(), device.defaultStiffnessNewtonPerMm()));
  }

  private SessionSettings copy(Consumer<Draft> change) {
    Draft draft = new Draft(this);
    change.accept(draft);
    return draft.settings();
  }

  /** The settings while one of them changes. */
  private static final class Draft {
    private OptionalDouble defaultNewtonPerMm;
    private LoopSettings loop;
    private Optional<SampleRecorder> recorder;
    private Optional<EditRecorder> editRecorder;
    private Optional<BodyRecorder> bodyRecorder;
    private Optional<FieldRecorder> fieldRecorder;
    private Optional<Supplier<ElasticBody>> elastic;
    private Consumer<LoopEnd> listener;

    Draft(SessionSettings from) {
      defaultNewtonPerMm = from.defaultNewtonPerMm;
      loop = from.loop;
      recorder = from.recorder;
      editRecorder = from.editRecorder;
      bodyRecorder = from.bodyRecorder;
      fieldRecorder = from.fieldRecorder;
      elastic = from.elastic;
      listener = from.listener;
    }

    SessionSettings settings() {
      return new SessionSettings(
          defaultNewtonPerMm,
          loop,
          recorder,
          editRecorder,
          bodyRecorder,
          fieldRecorder,
          elastic,
          listener);
    }
  }
}
