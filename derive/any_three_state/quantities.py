"""What the kernels of a three-state model compute, each as a value of known parts."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from gainproof.derive.algebra.tower import Tower
from gainproof.derive.any_three_state import derivatives, forms
from gainproof.derive.any_three_state.basis import Basis
from gainproof.derive.any_three_state.forms import Form
from gainproof.derive.any_three_state.root_excess import excess
from gainproof.derive.any_two_state.signed_values import Signed
from gainproof.derive.model import ModelError

Values = Mapping[str, Signed]


@dataclass(frozen=True)
class Quantities:
    """Forms of the named quantities, each searched for once."""

    tower: Tower
    found: dict[str, Form] = field(default_factory=dict)

    def form(self, x: Basis, name: str) -> Form:
        """The form of a quantity."""
        if name not in self.found:
            self.found[name] = forms.find(x.shape, self.tower, self.tower.elements[name])
        return self.found[name]

    def value(self, x: Basis, name: str) -> Signed:
        """A quantity; a gain by the covariance above it where its own form would cancel."""
        if name in ("predicted_11", "alpha", "updated_11"):
            return self._first(x, "alpha" if name == "updated_11" else name)
        plain = {"updated_12": "beta", "updated_13": "gamma"}.get(name, name)
        form = self.form(x, plain)
        other = {"beta": "predicted_12", "gamma": "predicted_13"}.get(plain)
        if other and form.cancels and not self.form(x, other).cancels:
            n = x.sum_of_roots
            return self.value(x, other).times(64).over(n).over(n)
        return x.valued(form)

    def _first(self, x: Basis, name: str) -> Signed:
        """alpha = D (N + 8)/N^2 and M11 = D (N + 8)/64."""
        n = x.sum_of_roots
        try:
            more = excess(x)
        except ModelError:
            return x.valued(self.form(x, name))
        return Signed((more / n) * ((n + 8) / n) if name == "alpha" else more * (n + 8) / 64)

    def gains(self, x: Basis) -> Values:
        """Filter gain."""
        return {name: self.value(x, name) for name in ("alpha", "beta", "gamma")}

    def predicted_covariance(self, x: Basis) -> Values:
        """Entries of the predicted covariance."""
        return self._entries(x, "predicted")

    def updated_covariance(self, x: Basis) -> Values:
        """Entries of the updated covariance."""
        return self._entries(x, "updated")

    def gain_derivatives(self, x: Basis) -> Values:
        """Derivatives of the filter gain by the index."""
        found = {"alpha": Signed(derivatives.alpha(x))}
        for name in ("beta", "gamma"):
            key = f"{name}'"
            if key not in self.found:
                self.found[key] = derivatives.gain_form(x.shape, self.tower, name)
            found[name] = x.valued(self.found[key])
        return found

    def _entries(self, x: Basis, kind: str) -> Values:
        places = ("11", "12", "13", "22", "23", "33")
        return {f"{kind}_{place}": self.value(x, f"{kind}_{place}") for place in places}


ValuesOf = Callable[[Basis], Values]
