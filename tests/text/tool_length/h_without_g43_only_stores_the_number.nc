(run with: --set #11001=100)
O1 (TLC-3: #4111 shows it)
H1
#100=#4111 (expect #100=1)
G90 G00 Z10.
#101=#5023 (expect #101=10)
M30
