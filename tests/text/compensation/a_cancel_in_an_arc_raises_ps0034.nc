(run with: --set #13001=5)
O1 (CRC-12: end in a G00 or G01 block)
G90 G00 Y-20.
G41 D1 G01 X0 Y0 F100
Y50.
G40 G02 X10. Y60. R10. (expect alarm PS0034)
M30
