package org.palpate.documents;

import com.sun.source.tree.BinaryTree;
import com.sun.source.tree.ClassTree;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.ConditionalExpressionTree;
import com.sun.source.tree.ExpressionTree;
import com.sun.source.tree.IdentifierTree;
import com.sun.source.tree.LiteralTree;
import com.sun.source.tree.MemberSelectTree;
import com.sun.source.tree.MethodInvocationTree;
import com.sun.source.tree.MethodTree;
import com.sun.source.tree.NewClassTree;
import com.sun.source.tree.ParenthesizedTree;
import com.sun.source.tree.Tree;
import com.sun.source.tree.VariableTree;
import com.sun.source.util.TreeScanner;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import javax.lang.model.element.Modifier;

/**
 * The error messages in the sources: {@code WHAT: WHERE: what to do}, with values in braces.
 *
 * <p>A message is found where its exception is made. A method that makes an exception from one of
 * its own texts counts as such a place too, and so do those that call it.
 */
final class MessageSources {
  /**
   * A message.
   *
   * @param source the simple name of the class that makes it
   * @param what what is wrong
   * @param where the file, the option or another input; empty if the message has no such part
   * @param remedy what the user can do; empty if the message is one sentence
   */
  record Message(String source, String what, String where, String remedy) {
    private Message with(String newSource, Map<String, String> values) {
      return new Message(
          newSource, filled(what, values), filled(where, values), filled(remedy, values));
    }

    private boolean names(String parameter) {
      return (what + where + remedy).contains("{" + parameter + "}");
    }
  }

  /** The parts of a message among the arguments of a call; -1 for a part that it lacks. */
  private record Parts(int what, int where, int remedy) {}

  private static final Parts THREE = new Parts(0, 1, 2);
  private static final Parts SENTENCE = new Parts(0, -1, -1);

  /** The calls that make an exception, by name and number of arguments. */
  private static final Map<String, Parts> MAKERS =
      Map.ofEntries(
          Map.entry("VolumeFormatException/3", THREE),
          Map.entry("VolumeFormatException/4", THREE),
          Map.entry("CsvFormatException/3", THREE),
          Map.entry("CsvFormatException/4", new Parts(0, 1, 3)),
          Map.entry("CaptureFormatException/2", new Parts(1, -1, -1)),
          Map.entry("WrongChoiceException/1", SENTENCE),
          Map.entry("GraphicsException/3", new Parts(0, -1, 1)),
          Map.entry("TouchRefusedException/1", SENTENCE),
          Map.entry("DeviceException/1", SENTENCE),
          Map.entry("LinkProtocolException/1", SENTENCE),
          Map.entry("wrongUse/2", SENTENCE),
          Map.entry("failed/2", SENTENCE),
          Map.entry("wrongUse/3", THREE),
          Map.entry("wrongUse/4", THREE),
          Map.entry("failed/4", THREE));

  private final List<CompilationUnitTree> units;

  /** The messages of methods that make exceptions from their own parameters. */
  private final Map<String, List<Message>> templates = new HashMap<>();

  private final Map<String, List<String>> parameters = new HashMap<>();

  /** The text of each constant, by the name of its class and its own. */
  private final Map<String, String> constants = new HashMap<>();

  /** The class whose texts are read at present. */
  private String reading = "";

  private MessageSources(List<CompilationUnitTree> units) {
    this.units = units;
  }

  /** Returns every message of the given classes, each once, in the order of the classes. */
  static Set<Message> of(Map<String, String> classes) throws IOException {
    return new MessageSources(SourceTrees.of(classes).units()).find();
  }

  private Set<Message> find() {
    units.forEach(unit -> new Constants().scan(unit, null));
    units.forEach(unit -> new Constants().scan(unit, null)); // those made of others
    int known = -1;
    while (known < templates.size()) { // until no further method is found that passes a text on
      known = templates.size();
      units.forEach(unit -> new Finder(unit, new LinkedHashSet<>()).scan(unit, null));
    }
    Set<Message> messages = new LinkedHashSet<>();
    units.forEach(unit -> new Finder(unit, messages).scan(unit, null));
    return messages;
  }

  private static String filled(String text, Map<String, String> values) {
    String result = text;
    for (Map.Entry<String, String> value : values.entrySet()) {
      result = result.replace("{" + value.getKey() + "}", value.getValue());
    }
    return result;
  }

  /** Returns a text as a person reads it in a catalogue: literals, and values in braces. */
  private String text(ExpressionTree tree) {
    if (tree instanceof LiteralTree literal) {
      return literal.getValue() instanceof String text ? text : String.valueOf(literal.getValue());
    }
    if (tree instanceof ParenthesizedTree parenthesized) {
      return text(parenthesized.getExpression());
    }
    if (tree instanceof BinaryTree binary && binary.getKind() == Tree.Kind.PLUS) {
      return text(binary.getLeftOperand()) + text(binary.getRightOperand());
    }
    if (tree instanceof ConditionalExpressionTree choice) {
      return "[" + text(choice.getTrueExpression()) + "/" + text(choice.getFalseExpression()) + "]";
    }
    if (tree instanceof MethodInvocationTree call) {
      boolean isFormat = nameOf(call.getMethodSelect()).equals("format");
      return isFormat ? format(call) : "{" + nameOf(call.getMethodSelect()) + "}";
    }
    String owner =
        tree instanceof MemberSelectTree select ? nameOf(select.getExpression()) : reading;
    return constants.getOrDefault(owner + "." + nameOf(tree), "{" + nameOf(tree) + "}");
  }

  private static String classOf(CompilationUnitTree unit) {
    String path = unit.getSourceFile().getName();
    return path.substring(path.lastIndexOf('/') + 1).replace(".java", "");
  }

  /** Returns the first text among the arguments, after a locale if there is one. */
  private String format(MethodInvocationTree call) {
    return call.getArguments().stream()
        .map(this::text)
        .filter(text -> text.contains("%"))
        .findFirst()
        .map(text -> text.replaceAll("%[-+0-9.,]*[a-zA-Z]", "{number}").replace("%%", "%"))
        .orElse("{text}");
  }

  /** Whether a tree is a literal of another type than a text, such as the number of a column. */
  private static boolean isNumber(ExpressionTree tree) {
    return tree instanceof LiteralTree literal && !(literal.getValue() instanceof String);
  }

  private static String nameOf(ExpressionTree tree) {
    if (tree instanceof MemberSelectTree select) {
      return select.getIdentifier().toString();
    }
    return tree instanceof IdentifierTree identifier ? identifier.getName().toString() : "value";
  }

  /** Finds the texts of constants. */
  private final class Constants extends TreeScanner<Void, Void> {
    @Override
    public Void visitCompilationUnit(CompilationUnitTree unit, Void unused) {
      reading = classOf(unit);
      return super.visitCompilationUnit(unit, null);
    }

    @Override
    public Void visitVariable(VariableTree variable, Void unused) {
      boolean isConstant = variable.getModifiers().getFlags().contains(Modifier.STATIC);
      if (isConstant && String.valueOf(variable.getType()).equals("String")) {
        Optional.ofNullable(variable.getInitializer())
            .map(MessageSources.this::text)
            .filter(text -> !text.contains("{"))
            .ifPresent(text -> constants.put(reading + "." + variable.getName(), text));
      }
      return super.visitVariable(variable, null);
    }
  }

  /** Finds the messages of one file. */
  private final class Finder extends TreeScanner<Void, Void> {
    private final String packageName;
    private final String source;
    private final Set<Message> found;
    private List<String> ownParameters = List.of();
    private String method = "";

    Finder(CompilationUnitTree unit, Set<Message> found) {
      packageName = String.valueOf(unit.getPackageName());
      source = classOf(unit);
      this.found = found;
    }

    @Override
    public Void visitCompilationUnit(CompilationUnitTree unit, Void unused) {
      reading = source;
      return super.visitCompilationUnit(unit, null);
    }

    @Override
    public Void visitClass(ClassTree tree, Void unused) {
      // An exception's own constructors call each other.
      return MAKERS.keySet().stream().anyMatch(key -> key.startsWith(tree.getSimpleName() + "/"))
          ? null
          : super.visitClass(tree, null);
    }

    @Override
    public Void visitMethod(MethodTree tree, Void unused) {
      List<String> outerParameters = ownParameters;
      String outerMethod = method;
      ownParameters = tree.getParameters().stream().map(p -> p.getName().toString()).toList();
      method = packageName + "." + tree.getName() + "/" + ownParameters.size();
      if (source.equals("PalpateException")) {
        return null;
      }
      super.visitMethod(tree, null);
      ownParameters = outerParameters;
      method = outerMethod;
      return null;
    }

    @Override
    public Void visitNewClass(NewClassTree tree, Void unused) {
      visitCall(nameOf(tree.getIdentifier()), tree.getArguments());
      return super.visitNewClass(tree, null);
    }

    @Override
    public Void visitMethodInvocation(MethodInvocationTree tree, Void unused) {
      visitCall(nameOf(tree.getMethodSelect()), tree.getArguments());
      return super.visitMethodInvocation(tree, null);
    }

    private void visitCall(String name, List<? extends ExpressionTree> arguments) {
      String key = name + "/" + arguments.size();
      Parts parts = MAKERS.get(key);
      if (parts != null) {
        add(
            new Message(
                source,
                part(arguments, parts.what),
                part(arguments, parts.where),
                part(arguments, parts.remedy)));
        return;
      }
      String callee = packageName + "." + key;
      for (Message template : templates.getOrDefault(callee, List.of())) {
        Map<String, String> values = new LinkedHashMap<>();
        List<String> names = parameters.get(callee);
        for (int n = 0; n < names.size(); n++) {
          if (!isNumber(arguments.get(n))) {
            values.put(names.get(n), text(arguments.get(n)));
          }
        }
        add(template.with(source, values));
      }
    }

    private String part(List<? extends ExpressionTree> arguments, int index) {
      return index < 0 ? "" : text(arguments.get(index));
    }

    /** Adds a message, or notes its method if the text of a caller is missing in it. */
    private void add(Message message) {
      boolean isTemplate =
          ownParameters.stream()
              .anyMatch(p -> message.what.equals("{" + p + "}") || startsWith(message, p));
      if (isTemplate && ownParameters.stream().anyMatch(message::names)) {
        List<Message> known = templates.computeIfAbsent(method, each -> new ArrayList<>());
        if (!known.contains(message)) {
          known.add(message);
        }
        parameters.put(method, ownParameters);
      } else {
        found.add(message);
      }
    }

    private boolean startsWith(Message message, String parameter) {
      return message.what.startsWith("{" + parameter + "} ")
          && Set.of("what", "subject", "name").contains(parameter);
    }
  }
}
