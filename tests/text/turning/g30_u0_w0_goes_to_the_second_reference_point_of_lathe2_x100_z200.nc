(run with: --machine lathe2)
O1 (G30 U0 W0 goes to the second reference point of lathe2 X100 Z200)
G97S500M03
G00X60.Z5.
G30U0W0
M30
(finally moves: rapid X60 Z5; rapid X100 Z200)
