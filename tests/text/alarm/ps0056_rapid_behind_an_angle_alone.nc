(run with: --machine lathe2)
O1 (PS0056: a rapid has no angle)
G98 G00 X20. Z0.
G01 ,A170. F100
G28 U0 W0 (expect alarm PS0056)
M30
