(run with: --set #13001=5)
O1 (PS0041: a radius of 4 is too small for the tool)
G90 G00 X-20.
G42 D1 G01 X0 F100
X20.
G02 X24. Y-4. R4. (expect alarm PS0041)
G01 Y-50.
G40 X80.
M30
