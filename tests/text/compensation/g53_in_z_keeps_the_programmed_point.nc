(run with: --set #13001=5)
O1 (CRC-15, WCS-6: axes without a word in G53 keep their place, and their programmed value)
G90 G00 X-20. Y-10.
G41 D1 G01 X0 Y0 F200
Y50.
G53 Z0
#100=#5001 (expect #100=0)
#101=#5002 (expect #101=50)
G91 G01 X50. (expect moves: line X50 Y55)
G90 G40 Y60.
M30
