package org.palpate.scene.window;

import com.jogamp.newt.event.KeyAdapter;
import com.jogamp.newt.event.KeyEvent;
import com.jogamp.newt.event.KeyListener;
import com.jogamp.newt.event.MouseAdapter;
import com.jogamp.newt.event.MouseEvent;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import java.util.function.IntSupplier;
import java.util.function.Supplier;
import org.palpate.geometry.Vec3;
import org.palpate.scene.Camera;
import org.palpate.scene.SceneLegend;
import org.palpate.scene.SceneModel;
import org.palpate.scene.SceneState;
import org.palpate.scene.StandardView;
import org.palpate.scene.Stereo;
import org.palpate.scene.gl.LegendArea;
import org.palpate.scene.gl.PickedPoint;

/**
 * The actions of mouse and keys.
 *
 * <p>A left drag that begins on a surface touches it if the mouse is a device. A left drag with
 * Shift or a middle drag moves the scene, and others with keys go to {@link #onDrag}. Any other
 * drag turns the scene. The wheel zooms or, while touching, changes the pressure.
 *
 * <p>A press does nothing until the drawing thread has found what lies under it.
 */
public final class WindowInput extends MouseAdapter {
  /** The key with an arrow to the left, for {@link #onKey} and {@link #onHeldKey}. */
  public static final char LEFT = '\u2190';

  /** The key with an arrow up. */
  public static final char UP = '\u2191';

  /** The key with an arrow to the right. */
  public static final char RIGHT = '\u2192';

  /** The key with an arrow down. */
  public static final char DOWN = '\u2193';

  /** The key Page Up. */
  public static final char PAGE_UP = '\u21de';

  /** The key Page Down. */
  public static final char PAGE_DOWN = '\u21df';

  private static final double RADIANS_PER_HEIGHT = Math.PI;
  private static final double ZOOM_STEP = 0.9;
  private static final double MIN_PRESS = 0.002;
  private static final double MAX_PRESS = 0.2;

  private final SceneModel model;
  private final IntSupplier width;
  private final IntSupplier height;
  private final Supplier<LegendArea> legendArea;
  private final Map<Character, Key> keys = new LinkedHashMap<>();
  private final AtomicReference<Pick> requestedPick = new AtomicReference<>();
  private final AtomicReference<Gesture> gesture = new AtomicReference<>(Gesture.NONE);
  private volatile Optional<PointerListener> pointer = Optional.empty();
  private volatile double pressFraction = 0.02;
  private Optional<SceneLegend> legend = Optional.empty();
  private final Map<DragKeys, Drag> drags = new EnumMap<>(DragKeys.class);
  private Optional<DragListener> presentDrag = Optional.empty();
  private final List<String> notes = new ArrayList<>();
  private String wheelHelp = "";
  private DoubleConsumer wheelWithKeys;
  private volatile Optional<TextEntry> entry = Optional.empty();
  private boolean helpShown;
  private int lastX;
  private int lastY;

  /** The action of a key; {@code repeats} means that it repeats while the key is held down. */
  private record Key(String help, Runnable action, boolean repeats) {}

  /** The keys that are held down during a left drag. */
  public enum DragKeys {
    CONTROL("Ctrl and drag"),
    CONTROL_AND_SHIFT("Ctrl, Shift and drag");

    private final String text;

    DragKeys(String text) {
      this.text = text;
    }
  }

  /** The action of a drag with keys. */
  private record Drag(String help, DragListener listener) {}

  /** The action of the mouse while a button is held down. */
  private enum Gesture {
    NONE,
    /** A press before the drawing thread has found whether it met a surface. */
    UNDECIDED,
    TOUCH,
    TURN,
    MOVE,
    /** A drag with keys, which the owner's listener receives. */
    KEYS
  }

  /**
   * A request to find what lies under the mouse.
   *
   * @param x pixels from the left
   * @param y pixels from the top
   * @param begins whether a press begins there
   */
  private record Pick(int x, int y, boolean begins) {}

  WindowInput(
      SceneModel model, IntSupplier width, IntSupplier height, Supplier<LegendArea> legendArea) {
    this.model = model;
    this.legendArea = legendArea;
    this.width = width;
    this.height = height;
    addViewKeys();
  }

  private void addViewKeys() {
    onKey('f', "front view", () -> look(StandardView.FRONT));
    onKey('b', "back view", () -> look(StandardView.BACK));
    onKey('l', "left view", () -> look(StandardView.LEFT));
    onKey('r', "right view", () -> look(StandardView.RIGHT));
    onKey('t', "view from the head", () -> look(StandardView.HEAD));
    onKey('u', "view from the foot", () -> look(StandardView.FOOT));
    onKey('o', "oblique view, fits all", () -> look(StandardView.OBLIQUE));
    onKey('d', "dark or light", () -> model.changeLook(SceneState.Look::withOtherTheme));
    onKey(
        '3',
        "stereo: off, anaglyph, side by side",
        () -> model.changeLook(WindowInput::nextStereo));
    onKey('8', "cut open at the point: across x, y, z, facing you, off", model::clipNext);
    onKey('h', "this help", this::toggleHelp);
  }

  private static SceneState.Look nextStereo(SceneState.Look look) {
    return look.with(
        switch (look.stereo()) {
          case OFF -> Stereo.ANAGLYPH;
          case ANAGLYPH -> Stereo.SIDE_BY_SIDE;
          default -> Stereo.OFF;
        });
  }

  private void look(StandardView view) {
    model.look(view, (double) Math.max(1, width.getAsInt()) / Math.max(1, height.getAsInt()));
  }

  /**
   * Assigns an action to a key. {@code help} describes it in a few words. Any thread, before the
   * window is shown.
   */
  public void onKey(char key, String help, Runnable action) {
    synchronized (keys) {
      keys.put(key, new Key(help, action, false));
    }
  }

  /** Assigns an action that repeats while the key is held down. */
  public void onHeldKey(char key, String help, Runnable action) {
    synchronized (keys) {
      keys.put(key, new Key(help, action, true));
    }
  }

  /** Shows a legend with keys and clicks. Before the window is shown. */
  public void addLegend() {
    SceneLegend shown = new SceneLegend(model);
    legend = Optional.of(shown);
    onKey('j', "legend: next segment", shown::selectNext);
    onKey('v', "legend: hide or show it (or click its name)", shown::toggle);
    onKey('i', "legend: next colour (or click its colour)", shown::nextColour);
  }

  /** Receives a drag. On the window's own thread. */
  public interface DragListener {
    /** Receives the distances to the right and upwards since the last call, in picture heights. */
    void dragged(double right, double up);
  }

  /** Assigns an action to left drags with keys. Before the window is shown. */
  public void onDrag(DragKeys held, String help, DragListener listener) {
    drags.put(held, new Drag(help, listener));
  }

  /**
   * Assigns an action to the wheel while Ctrl and Shift are held down. Before the window is shown.
   *
   * @param listener receives steps, positive away from the user, on the window's own thread
   */
  public void onWheelWithKeys(String help, DoubleConsumer listener) {
    wheelHelp = help;
    wheelWithKeys = listener;
  }

  /** Adds a line to the help that belongs to no key. Before the window is shown. */
  public void addNote(String line) {
    notes.add(line);
  }

  /** Whether a drag with these keys has an action. */
  public boolean hasDrag(DragKeys held) {
    return drags.containsKey(held);
  }

  /**
   * Returns the rotation vector of a turn about axes of the present picture, world axes, rad; see
   * {@link Camera#turn}.
   */
  public Vec3 turnInView(Vec3 rotationVector) {
    return model.camera().turn(rotationVector, model.axes());
  }

  /**
   * Asks for a line of text, which the user ends with Enter. Escape keeps the first text. Any
   * thread.
   *
   * @param taker receives the text, on the window's own thread
   */
  public void ask(String prompt, String first, Consumer<String> taker) {
    TextEntry asked = new TextEntry(prompt, first, taker);
    entry = Optional.of(asked);
    model.setHelp(asked.lines());
  }

  private void type(TextEntry asked, KeyEvent event) {
    boolean goesOn = asked.type(event.getKeyCode(), event.getKeyChar(), event.isPrintableKey());
    entry = goesOn ? entry : Optional.empty();
    model.setHelp(goesOn ? asked.lines() : helpShown ? helpLines() : List.of());
  }

  /** Makes the mouse the device. */
  public void setPointer(PointerListener listener) {
    pointer = Optional.of(listener);
  }

  /** Runs the action of a key, if it has one. */
  void press(char key) {
    press(key, false);
  }

  private void press(char key, boolean isRepeat) {
    Key found;
    synchronized (keys) {
      found = keys.get(Character.toLowerCase(key));
    }
    if (found != null && (found.repeats || !isRepeat)) {
      found.action.run();
    }
  }

  private void toggleHelp() {
    helpShown = !helpShown;
    model.setHelp(helpShown ? helpLines() : List.of());
  }

  private List<String> helpLines() {
    List<String> lines = new ArrayList<>();
    if (pointer.isPresent()) {
      lines.add("left drag on a surface   touch");
      lines.add("wheel during it   press deeper");
      lines.add("right drag, or beside it   turn");
    } else {
      lines.add("drag   turn");
    }
    lines.add("middle or Shift drag   move");
    lines.add("wheel   nearer or further");
    drags.forEach((held, drag) -> lines.add(held.text + "   " + drag.help));
    if (wheelWithKeys != null) {
      lines.add("Ctrl, Shift and wheel   " + wheelHelp);
    }
    synchronized (keys) {
      keys.forEach((key, action) -> lines.add(name(key) + "   " + action.help));
    }
    lines.addAll(notes);
    return lines;
  }

  private static String name(char key) {
    return switch (key) {
      case KeyEvent.VK_ESCAPE -> "Esc";
      case ' ' -> "Space";
      case LEFT -> "Left";
      case UP -> "Up";
      case RIGHT -> "Right";
      case DOWN -> "Down";
      case PAGE_UP -> "Page Up";
      case PAGE_DOWN -> "Page Down";
      default -> String.valueOf(key);
    };
  }

  /** Returns the character of a key that types none; 0 for a key without an action. */
  private static char character(short code) {
    return switch (code) {
      case KeyEvent.VK_ESCAPE -> (char) KeyEvent.VK_ESCAPE;
      case KeyEvent.VK_LEFT -> LEFT;
      case KeyEvent.VK_UP -> UP;
      case KeyEvent.VK_RIGHT -> RIGHT;
      case KeyEvent.VK_DOWN -> DOWN;
      case KeyEvent.VK_PAGE_UP -> PAGE_UP;
      case KeyEvent.VK_PAGE_DOWN -> PAGE_DOWN;
      default -> 0;
    };
  }

  /** Returns the listener for NEWT's key events. */
  KeyListener keys() {
    return new KeyAdapter() {
      @Override
      public void keyPressed(KeyEvent event) {
        Optional<TextEntry> asked = entry;
        if (asked.isPresent()) {
          type(asked.get(), event);
        } else if (character(event.getKeyCode()) != 0) {
          press(character(event.getKeyCode()), event.isAutoRepeat());
        } else if (event.isPrintableKey()) {
          press(event.getKeyChar(), event.isAutoRepeat());
        }
      }
    };
  }

  @Override
  public void mousePressed(MouseEvent event) {
    lastX = event.getX();
    lastY = event.getY();
    if (pressLegend(event)) {
      gesture.set(Gesture.NONE);
      return;
    }
    gesture.set(gestureOf(event));
    if (gesture.get() == Gesture.UNDECIDED) {
      requestPick(event, true);
    }
  }

  /** Hides or shows the segment of the legend under the mouse, or changes its colour. */
  private boolean pressLegend(MouseEvent event) {
    LegendArea area = legendArea.get();
    int segment = area.segmentAt(event.getX(), event.getY());
    if (segment < 0 || legend.isEmpty()) {
      return false;
    }
    legend.get().select(segment);
    if (area.isColour(event.getX())) {
      legend.get().nextColour();
    } else {
      legend.get().toggle();
    }
    return true;
  }

  private Gesture gestureOf(MouseEvent event) {
    boolean left = event.getButton() == MouseEvent.BUTTON1;
    presentDrag = left ? dragWithKeys(event) : Optional.empty();
    if (presentDrag.isPresent()) {
      return Gesture.KEYS;
    }
    if (event.getButton() == MouseEvent.BUTTON2 || (left && event.isShiftDown())) {
      return Gesture.MOVE;
    }
    return left && pointer.isPresent() ? Gesture.UNDECIDED : Gesture.TURN;
  }

  private Optional<DragListener> dragWithKeys(MouseEvent event) {
    if (!event.isControlDown()) {
      return Optional.empty();
    }
    DragKeys held = event.isShiftDown() ? DragKeys.CONTROL_AND_SHIFT : DragKeys.CONTROL;
    return Optional.ofNullable(drags.get(held)).map(Drag::listener);
  }

  private void requestPick(MouseEvent event, boolean begins) {
    requestedPick.set(new Pick(event.getX(), event.getY(), begins));
    model.requestRedraw();
  }

  @Override
  public void mouseDragged(MouseEvent event) {
    double dx = (event.getX() - lastX) / (double) Math.max(1, height.getAsInt());
    double dy = (event.getY() - lastY) / (double) Math.max(1, height.getAsInt());
    lastX = event.getX();
    lastY = event.getY();
    switch (gesture.get()) {
      case TOUCH -> requestPick(event, false);
      case KEYS -> presentDrag.ifPresent(listener -> listener.dragged(dx, -dy));
      case MOVE -> model.moveCamera(camera -> camera.pan(dx, -dy), true);
      case TURN ->
          model.moveCamera(
              camera -> camera.orbit(dx * RADIANS_PER_HEIGHT, -dy * RADIANS_PER_HEIGHT), true);
      case NONE, UNDECIDED -> {
        // Nothing moves until the drawing thread has looked.
      }
    }
  }

  @Override
  public void mouseReleased(MouseEvent event) {
    Gesture ended = gesture.getAndSet(Gesture.NONE);
    if (ended == Gesture.TURN || ended == Gesture.MOVE) {
      model.moveCamera(camera -> camera, false);
    }
  }

  @Override
  public void mouseWheelMoved(MouseEvent event) {
    double steps = event.getRotation()[1];
    if (wheelWithKeys != null && event.isControlDown() && event.isShiftDown()) {
      // With Shift, a wheel may turn sideways.
      wheelWithKeys.accept(steps == 0 ? event.getRotation()[0] : steps);
    } else if (gesture.get() == Gesture.TOUCH) {
      double pressed = pressFraction * Math.pow(ZOOM_STEP, -steps);
      pressFraction = Math.max(MIN_PRESS, Math.min(MAX_PRESS, pressed));
      requestPick(event, false);
    } else {
      model.moveCamera(camera -> camera.zoom(Math.pow(ZOOM_STEP, steps)), false);
    }
  }

  /**
   * Finds the point under the mouse if one was requested. Called by the drawing thread.
   *
   * @param finder returns the point that a pixel shows; the pixel counts from the upper left
   */
  void pick(BiFunction<Integer, Integer, Optional<PickedPoint>> finder) {
    Pick pick = requestedPick.getAndSet(null);
    if (pick == null || pointer.isEmpty()) {
      return;
    }
    Optional<PickedPoint> found = finder.apply(pick.x, pick.y);
    boolean touches = found.isPresent() && pointer.get().press(spot(found.get(), pick.begins));
    if (pick.begins && found.isEmpty()) {
      pointer.get().pressedBackground();
    }
    if (pick.begins) {
      // A button that was released meanwhile leaves no gesture.
      gesture.compareAndSet(Gesture.UNDECIDED, touches ? Gesture.TOUCH : Gesture.TURN);
    }
  }

  private PointerSpot spot(PickedPoint found, boolean begins) {
    SceneState state = model.state();
    Vec3 eye = model.axes().toSceneOrBack(found.eyeMm(), new Vec3());
    Vec3 surface = model.axes().toSceneOrBack(state.atRest(found.surfaceMm()), new Vec3());
    // A drawn surface may lie a voxel in front of what is touched.
    double depthMm = pressFraction * state.radiusMm() + state.detailMm();
    return new PointerSpot(eye, surface, depthMm, begins);
  }
}
