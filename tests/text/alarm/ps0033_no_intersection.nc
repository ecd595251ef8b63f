(run with: --set #13001=5)
O1 (PS0033: the offset line at Y5 misses the offset arc of 3)
G90 G00 X-20.
G41 D1 G01 X0 F100
X20.
G03 X12. Y8. I-8. J0
G01 X0
G40 Y50.
M30
(finally alarm PS0033)
