(run with: --machine lathe2)
O1 (A is an angle of the tip, on a machine without such an axis)
G97 S500 M03
G00 X24. Z4.
G76 X17. Z-16. K1. D400 F1.5 A61 (expect alarm PS0315 at A61)
M30
