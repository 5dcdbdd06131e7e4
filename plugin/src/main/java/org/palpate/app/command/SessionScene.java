package org.palpate.app.command;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.palpate.app.options.ChosenCollisionDevice;
import org.palpate.app.options.ToolOptions;
import org.palpate.app.options.VolumeSource;
import org.palpate.app.output.MassFields;
import org.palpate.app.output.NeedleFields;
import org.palpate.app.output.ProtectedFields;
import org.palpate.app.output.Report;
import org.palpate.app.output.ToolReport;
import org.palpate.body.BodyScene;
import org.palpate.body.Placement;
import org.palpate.collision.CollisionDevice;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.GuidedHand;
import org.palpate.device.HandTarget;
import org.palpate.device.HapticDevice;
import org.palpate.device.Tremor;
import org.palpate.force.guide.FitExchange;
import org.palpate.fracture.fit.FaceFit;
import org.palpate.frame.ToolFrame;
import org.palpate.geometry.Pose;
import org.palpate.host.ContactScene;
import org.palpate.host.SessionSettings;
import org.palpate.host.SessionView;
import org.palpate.host.ToolScene;
import org.palpate.host.TouchSession;
import org.palpate.host.placing.FaceFitting;
import org.palpate.host.placing.HeldReadings;
import org.palpate.host.placing.LiveReadings;
import org.palpate.io.scene.PlacedVolume;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.reduction.ReductionPlan;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.tool.MadeTool;
import org.palpate.volume.SegmentedVolume;

/** The scene of a live session, which a point or a rigid tool touches. */
final class SessionScene {
  /** About the time in which a simulated hand goes from where it begins to its first fragment. */
  private static final double APPROACH_SECONDS = 1;

  private final ContactScene scene;
  private final Optional<ToolScene> rigid;
  private final Optional<ToolReport> toolReport;
  private final Optional<FaceFit> fit;

  private SessionScene(
      ContactScene scene,
      Optional<ToolScene> rigid,
      Optional<ToolReport> toolReport,
      Optional<FaceFit> fit) {
    this.scene = scene;
    this.rigid = rigid;
    this.toolReport = toolReport;
    this.fit = fit;
  }

  /**
   * Returns the scene of a session.
   *
   * @param made the rigid tool; empty for a point
   * @param device judges the legs of a rigid tool
   * @throws VolumeFormatException if the clearance of the tool is too large for the volume
   */
  static SessionScene of(
      ContactScene scene, ToolOptions options, Optional<MadeTool> made, CollisionDevice device)
      throws VolumeFormatException {
    if (made.isEmpty()) {
      return new SessionScene(scene, Optional.empty(), Optional.empty(), Optional.empty());
    }
    return new SessionScene(
        scene,
        Optional.of(options.scene(scene, made.get(), Set.of(), device)),
        Optional.of(new ToolReport(made.get(), options.massKg())),
        Optional.empty());
  }

  /**
   * Returns this scene with what finds the fit of a fragment in hand.
   *
   * @param found belongs to one session; empty without a guide to a fit
   */
  SessionScene withFit(Optional<FaceFit> found) {
    return new SessionScene(scene, rigid, toolReport, found);
  }

  /** Returns the volume with its contact settings. */
  ContactScene contactScene() {
    return scene;
  }

  /** Returns the volume that is touched. */
  SegmentedVolume volume() {
    return scene.volume();
  }

  /** Returns the rigid tool; empty for a point. */
  Optional<RigidTool> tool() {
    return rigid.map(ToolScene::tool);
  }

  /** Returns the region that a simulated hand touches, world mm. */
  HandTarget handTarget() {
    return rigid.map(ToolScene::handTarget).orElseGet(scene::handTarget);
  }

  /**
   * Returns a simulated hand that puts the fragments of a bone back to where they rest, and then
   * stays. It begins straight in front of its first fragment. Its plan is made in another thread,
   * on bodies of its own.
   *
   * @param seed chooses the phases of its tremor
   * @param periodNanos time between two samples, positive
   */
  HapticDevice reducingHand(long seed, long periodNanos) {
    ToolScene tool = rigid.orElseThrow();
    BodyScene seen = tool.bodies();
    BodyScene planned = scene.newBodies();
    List<Pose> truth = Collections.nCopies(seen.count(), new Pose());
    double radiusMm = handTarget().radiusMm();
    return new PlannedHand(
        radiusMm,
        () -> {
          ReductionPlan plan = ReductionPlan.of(planned, truth, tool.movableShapes(), seen);
          GuidedHand hand =
              new GuidedHand(plan.stops(), Tremor.ofHand(seed), radiusMm, periodNanos);
          hand.beginAfter(plan.firstApproach(), GuidedHand.MM_PER_SECOND * APPROACH_SECONDS);
          return hand;
        });
  }

  /** Returns placed bodies where the session has left them, and segments where they rest. */
  PlacedVolume left(VolumeSource source) {
    return source
        .placed()
        .map(this::ended)
        .orElseGet(
            () ->
                PlacedVolume.atRest(volume(), source.header().coordinateSystem(), source.origin()));
  }

  private PlacedVolume ended(PlacedVolume start) {
    BodyScene bodies = rigid.orElseThrow().bodies();
    List<Pose> poses = new ArrayList<>();
    for (int n = 0; n < bodies.count(); n++) {
      poses.add(bodies.body(n).pose());
    }
    return start.at(poses);
  }

  /** Returns notes for the user, a sentence each. */
  List<String> notes(DeviceSpecification device) {
    List<String> notes = new ArrayList<>();
    boolean canTurn = rigid.filter(made -> made.tool().count() > 1).isPresent();
    if (canTurn && !device.hasOrientation()) {
      notes.add("The device has no orientation, so the tool is held upright.");
    }
    if (!scene.tissues().isEmpty()) {
      notes.add(
          "The needle may enter "
              + String.join(", ", scene.tissues().keySet())
              + "; it enters nothing else.");
    }
    return notes;
  }

  /**
   * Returns readings of the fragment in hand for a view; empty if no body can be taken.
   *
   * @param ghosts what it is also read against, if there is any
   */
  Optional<LiveReadings> readings(
      TouchSession session,
      SessionView view,
      ConsoleViewListener listener,
      Optional<SegmentedVolume> ghosts) {
    Optional<LiveReadings> readings =
        session
            .toolFrame()
            .filter(frame -> session.canHold() && !scene.placements().isEmpty())
            .map(frame -> newReadings(frame, view, listener, ghosts));
    readings.ifPresent(made -> listener.addKeys(made.colours()::addTo));
    return readings;
  }

  private LiveReadings newReadings(
      ToolFrame frame,
      SessionView view,
      ConsoleViewListener listener,
      Optional<SegmentedVolume> ghosts) {
    List<Pose> starts = scene.placements().stream().map(Placement::pose).toList();
    return new LiveReadings(
        frame,
        new HeldReadings(scene.volume(), starts, ghosts),
        scene.volume(),
        view,
        listener::landmarkLines);
  }

  /** Returns what fits the fragment in hand to the others; empty without a guide to a fit. */
  Optional<FaceFitting> fitting(TouchSession session, FitExchange fits) {
    return fit.flatMap(
        each -> session.toolFrame().map(frame -> new FaceFitting(frame, each, fits)));
  }

  /** Returns a new session; see {@link TouchSession}. */
  TouchSession newSession(HapticDevice device, SessionSettings settings) {
    return rigid.isPresent()
        ? new TouchSession(rigid.get(), device, settings)
        : new TouchSession(scene, device, settings);
  }

  /** Adds the fields that depend on the tool to a report. */
  void putInto(Report report, TouchReport measured, ChosenCollisionDevice judge) {
    ProtectedFields.put(report, scene, measured::secondsOf);
    if (toolReport.isPresent()) {
      report
          .put("max_torque_nmm", measured.maxTorqueNewtonMm())
          .put("solver", ToolReport.SOLVER)
          .put("collision", ToolReport.COLLISION)
          .put("tool", toolReport.get().tool(measured.mostReducedPoints()))
          .put("collision_device", judge.fields())
          .put("faults", measured.toolFaults());
      NeedleFields.put(report, rigid.orElseThrow());
      MassFields.put(report, rigid.orElseThrow());
    } else {
      report
          .put("solver", scene.settings().solver().toString())
          .put("collision", scene.settings().collision().toString());
    }
  }
}
