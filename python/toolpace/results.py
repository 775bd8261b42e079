"""What the commands return."""


class Result:
    """The keys of --json: as attributes (o.cycle_time_s), as items (o["cycle_time_s"]), and all of them as the dict o.summary.

    exit_code: that of the command line: 1 where a limit check failed, which is no exception; told: what the command line would
    print beside the result, such as warnings.
    """

    def __init__(self, summary, exit_code, told):
        self.summary = summary
        self.exit_code = exit_code
        self.told = told

    def __getattr__(self, name):
        summary = self.__dict__.get("summary", {})
        if name in summary:
            return summary[name]
        raise AttributeError(f"{type(self).__name__} has no {name!r}; it has {', '.join(summary)}")

    def __getitem__(self, key):
        return self.summary[key]

    def __contains__(self, key):
        return key in self.summary

    def __iter__(self):
        return iter(self.summary)

    def keys(self):
        return self.summary.keys()

    def __dir__(self):
        return [*super().__dir__(), *self.summary]

    def __repr__(self):
        return f"{type(self).__name__}({self.summary!r})"


class Plan(Result):
    """A planned program, with its setpoints. toolpace.replan() plans it again under other flags."""

    def __init__(self, summary, exit_code, told, core, asked, tip_of):
        super().__init__(summary, exit_code, told)
        self._core, self._asked, self._tip_of, self._table = core, asked, tip_of, None

    def _tabled(self):
        if self._table is None:
            self._table = self._core.setpoints(self._tip_of)
        return self._table

    @property
    def columns(self):
        """Names of the columns: t_s, x_mm, y_mm, z_mm, (a_deg, b_deg, c_deg,) v_mm_s, a_mm_s2, j_mm_s3;
        with tip=True tip_x_mm, tip_y_mm, tip_z_mm."""
        return self._tabled()[0]

    @property
    def setpoints(self):
        """numpy array, one row a period, as in a .npy file. Computed when it is first asked for; how many rows there are is
        summary["setpoints"]."""
        return self._tabled()[1]

    @property
    def lines(self):
        """numpy array: the NC line of each row."""
        return self._tabled()[2]

    def column(self, name):
        """One column of the setpoints; a view, not a copy."""
        if name not in self.columns:
            raise KeyError(f"there is no column {name!r}; there are {', '.join(self.columns)}")
        return self.setpoints[:, self.columns.index(name)]

    def __repr__(self):
        return f"<toolpace.Plan of {self.summary['program']}: {self.summary['cycle_time_s']:.4f} s>"


class Pulses(Result):
    """A stepper's move, with its pulses."""

    def __init__(self, summary, exit_code, told, core):
        super().__init__(summary, exit_code, told)
        self._core, self._intervals = core, None

    @property
    def intervals(self):
        """numpy array: timer ticks before each pulse. Computed when it is first asked for."""
        if self._intervals is None:
            self._intervals = self._core.ticks()
        return self._intervals
