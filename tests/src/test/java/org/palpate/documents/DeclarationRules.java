package org.palpate.documents;

import com.sun.source.doctree.DocCommentTree;
import com.sun.source.doctree.DocTree;
import com.sun.source.doctree.ParamTree;
import com.sun.source.doctree.ReturnTree;
import com.sun.source.doctree.ThrowsTree;
import com.sun.source.tree.ClassTree;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.LambdaExpressionTree;
import com.sun.source.tree.LiteralTree;
import com.sun.source.tree.MethodTree;
import com.sun.source.tree.NewClassTree;
import com.sun.source.tree.ThrowTree;
import com.sun.source.tree.Tree;
import com.sun.source.tree.TypeParameterTree;
import com.sun.source.tree.VariableTree;
import com.sun.source.util.TreePathScanner;
import com.sun.source.util.TreeScanner;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.lang.model.element.Modifier;

/**
 * The rules for names, texts and comments of declarations that a machine can decide:
 *
 * <ul>
 *   <li>No type, no method and no sentence for users has a word that the glossary avoids.
 *   <li>A public or protected method has a comment. It states each parameter, the value that the
 *       method returns, and each exception that the method declares, or makes and throws itself.
 *   <li>A public class states its type parameters, and a record states its components.
 * </ul>
 */
final class DeclarationRules {
  /** Words that the glossary avoids and that mean nothing else in names and messages. */
  private static final Pattern AVOIDED =
      Pattern.compile(
          "\\b(openness|octets?|tally|tallies|near cubes?|box trees?|hops?|device points?"
              + "|obstacles?|wish(es)?|climbs?|twins?|walks?)\\b");

  private static final Pattern WORDS = Pattern.compile("(?<=[a-z0-9])(?=[A-Z])|_");

  private final SourceTrees sources;
  private final List<String> faults = new ArrayList<>();

  private DeclarationRules(SourceTrees sources) {
    this.sources = sources;
  }

  /** Returns the names and the sentences for users that have a word to avoid. */
  static List<String> faultsOfWords(SourceTrees sources) {
    DeclarationRules rules = new DeclarationRules(sources);
    sources.units().forEach(unit -> rules.new Words().scan(unit, null));
    return rules.faults;
  }

  /** Returns the visible methods and records whose comment is missing or incomplete. */
  static List<String> faultsOfComments(SourceTrees sources) {
    DeclarationRules rules = new DeclarationRules(sources);
    sources.units().forEach(unit -> rules.new Comments(unit).scan(unit, null));
    return rules.faults;
  }

  /** Looks for words to avoid. */
  private final class Words extends TreePathScanner<Void, Void> {
    private String owner = "";

    @Override
    public Void visitClass(ClassTree tree, Void unused) {
      String outer = owner;
      owner = tree.getSimpleName().toString();
      checkName(owner);
      super.visitClass(tree, null);
      owner = outer;
      return null;
    }

    @Override
    public Void visitMethod(MethodTree tree, Void unused) {
      checkName(tree.getName().toString());
      return super.visitMethod(tree, null);
    }

    @Override
    public Void visitLiteral(LiteralTree tree, Void unused) {
      if (tree.getValue() instanceof String text && text.strip().contains(" ")) {
        check(text.toLowerCase(Locale.ROOT), "\"" + text + "\"");
      }
      return null;
    }

    private void checkName(String name) {
      check(WORDS.matcher(name).replaceAll(" ").toLowerCase(Locale.ROOT), name);
    }

    private void check(String words, String what) {
      if (AVOIDED.matcher(words).find()) {
        faults.add(owner + ": " + what);
      }
    }
  }

  /** Looks for visible methods and records with an incomplete comment. */
  private final class Comments extends TreePathScanner<Void, Void> {
    private final String file;

    Comments(CompilationUnitTree unit) {
      String path = unit.getSourceFile().getName();
      file = path.substring(path.lastIndexOf('/') + 1).replace(".java", "");
    }

    @Override
    public Void visitClass(ClassTree tree, Void unused) {
      if (!isVisible(tree.getModifiers().getFlags()) && !isInInterface()) {
        return null;
      }
      DocCommentTree comment = sources.comments().getDocCommentTree(getCurrentPath());
      List<String> names = typeParameters(tree.getTypeParameters());
      names.addAll(components(tree));
      checkParameters(tree.getSimpleName().toString(), comment, names);
      return super.visitClass(tree, null);
    }

    /** Returns the names of type parameters as a comment states them, with their brackets. */
    private static List<String> typeParameters(List<? extends TypeParameterTree> parameters) {
      List<String> names = new ArrayList<>();
      parameters.forEach(parameter -> names.add("<" + parameter.getName() + ">"));
      return names;
    }

    /** Returns the names of the components of a record; none for other classes. */
    private static List<String> components(ClassTree tree) {
      List<String> names = new ArrayList<>();
      for (Tree member : tree.getMembers()) {
        if (tree.getKind() == Tree.Kind.RECORD
            && member instanceof VariableTree field
            && !field.getModifiers().getFlags().contains(Modifier.STATIC)) {
          names.add(field.getName().toString());
        }
      }
      return names;
    }

    /** Whether the present class is a member of an interface, and so is public as well. */
    private boolean isInInterface() {
      Tree parent = getCurrentPath().getParentPath().getLeaf();
      return parent.getKind() == Tree.Kind.INTERFACE;
    }

    private static boolean isVisible(Set<Modifier> modifiers) {
      return modifiers.contains(Modifier.PUBLIC) || modifiers.contains(Modifier.PROTECTED);
    }

    @Override
    public Void visitMethod(MethodTree tree, Void unused) {
      ClassTree owner = (ClassTree) getCurrentPath().getParentPath().getLeaf();
      boolean isVisible =
          isVisible(tree.getModifiers().getFlags())
              || (owner.getKind() == Tree.Kind.INTERFACE
                  && !tree.getModifiers().getFlags().contains(Modifier.PRIVATE));
      if (isVisible && !isOverride(tree)) {
        check(tree, owner);
      }
      return null; // classes within methods are not visible
    }

    private static boolean isOverride(MethodTree tree) {
      return tree.getModifiers().getAnnotations().stream()
          .anyMatch(annotation -> annotation.getAnnotationType().toString().equals("Override"));
    }

    private void check(MethodTree tree, ClassTree owner) {
      String what = file + "." + tree.getName();
      DocCommentTree comment = sources.comments().getDocCommentTree(getCurrentPath());
      if (comment == null) {
        faults.add(what + " has no comment");
        return;
      }
      checkParameters(what, comment, parameters(tree, owner));
      if (!isVoid(tree) && !statesResult(comment)) {
        faults.add(what + " does not state what it returns");
      }
      for (String exception : thrownBy(tree)) {
        if (!states(comment, exception)) {
          faults.add(what + " does not state when it throws " + exception);
        }
      }
    }

    /** Returns the exceptions that a method declares, or makes and throws itself. */
    private static Set<String> thrownBy(MethodTree tree) {
      Set<String> thrown = new TreeSet<>();
      tree.getThrows().forEach(exception -> thrown.add(exception.toString()));
      new Throws(thrown).scan(tree.getBody(), null);
      return thrown;
    }

    private static boolean isVoid(MethodTree tree) {
      return tree.getReturnType() == null || tree.getReturnType().toString().equals("void");
    }

    /** Returns the names of what a comment on a method has to state as parameters. */
    private static List<String> parameters(MethodTree tree, ClassTree owner) {
      List<String> names = new ArrayList<>();
      tree.getParameters().forEach(parameter -> names.add(parameter.getName().toString()));
      if (tree.getReturnType() == null && names.equals(components(owner))) {
        return List.of(); // the record states them for its canonical constructor
      }
      names.addAll(0, typeParameters(tree.getTypeParameters()));
      return names;
    }

    private void checkParameters(String what, DocCommentTree comment, List<String> names) {
      for (String name : names) {
        if (comment == null || comment.getBlockTags().stream().noneMatch(tag -> isOf(tag, name))) {
          faults.add(what + " does not state " + name);
        }
      }
    }

    private static boolean isOf(DocTree tag, String parameter) {
      return tag instanceof ParamTree stated
          && !stated.getDescription().isEmpty()
          && parameter.equals(
              stated.isTypeParameter()
                  ? "<" + stated.getName() + ">"
                  : stated.getName().toString());
    }

    private static boolean statesResult(DocCommentTree comment) {
      return Stream.of(comment.getFullBody(), comment.getBlockTags())
          .flatMap(List::stream)
          .anyMatch(tag -> tag instanceof ReturnTree stated && !stated.getDescription().isEmpty());
    }

    private static boolean states(DocCommentTree comment, String exception) {
      return comment.getBlockTags().stream()
          .anyMatch(
              tag ->
                  tag instanceof ThrowsTree stated
                      && stated.getExceptionName().toString().equals(exception)
                      && !stated.getDescription().isEmpty());
    }
  }

  /** Collects the exceptions that a body makes and throws, but for those of lambdas and classes. */
  private static final class Throws extends TreeScanner<Void, Void> {
    private final Set<String> thrown;

    Throws(Set<String> thrown) {
      this.thrown = thrown;
    }

    @Override
    public Void visitThrow(ThrowTree tree, Void unused) {
      if (tree.getExpression() instanceof NewClassTree made) {
        thrown.add(made.getIdentifier().toString());
      }
      return null;
    }

    @Override
    public Void visitLambdaExpression(LambdaExpressionTree tree, Void unused) {
      return null;
    }

    @Override
    public Void visitClass(ClassTree tree, Void unused) {
      return null;
    }
  }
}
