(run with: --set #13001=5)
O1 (CRC-18: #5001 is programmed, #5041 compensated)
G90 G00 X-20. Y-10.
G41 D1 G01 X0 Y0 F100
Y50.
X50.
#100=#5001 (expect #100=50)
#101=#5002 (expect #101=50)
#102=#5042 (expect #102=55)
Y0
G40 X80.
M30
