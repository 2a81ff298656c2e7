## -*- texinfo -*-
## @deftypefn {} {@var{mathml} =} mathml_sign (@var{token})
## The MathML of a command of TeX that stands for a letter, an operator or a space; of any other @var{token} [].
## @end deftypefn

function mathml = mathml_sign (token)
  persistent letters = struct ("alpha", "α", "beta", "β", "gamma", "γ", "delta", "δ", "varepsilon", "ε", ...
                               "theta", "θ", "kappa", "κ", "lambda", "λ", "mu", "μ", "xi", "ξ", "pi", "π", ...
                               "rho", "ρ", "sigma", "σ", "tau", "τ", "varphi", "φ", "chi", "χ", "psi", "ψ", ...
                               "omega", "ω", "Gamma", "Γ", "Phi", "Φ", "partial", "∂", "bullet", "•");
  persistent operators = struct ("cdot", "·", "times", "×", "sum", "∑", "int", "∫");
  persistent spaces = {"!", ""; ",", "<mspace width=\"0.17em\"/>"; ";", "<mspace width=\"0.3em\"/>"};
  mathml = [];
  name = token(2:end);
  if (token(1) != "\\")
    return;
  elseif (isfield (letters, name))
    mathml = ["<mi>" letters.(name) "</mi>"];
  elseif (isfield (operators, name))
    mathml = ["<mo>" operators.(name) "</mo>"];
  elseif (any (strcmp (name, spaces(:,1))))
    mathml = spaces{strcmp (name, spaces(:,1)),2};
  endif
endfunction

%!assert (mathml_sign ("\\varphi"), "<mi>φ</mi>")
%!assert (mathml_sign ("\\int"), "<mo>∫</mo>")
%!assert (mathml_sign ("\\!"), "")
%!assert (mathml_sign ("\\;"), "<mspace width=\"0.3em\"/>")
%!assert (mathml_sign ("\\foo"), [])
%!assert (mathml_sign ("pi"), [])
%!assert (mathml_sign ("!"), [])
