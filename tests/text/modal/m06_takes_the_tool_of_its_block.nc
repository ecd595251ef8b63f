O1 (G-5: T5 M06)
G90 G00 X1.
T5 M06
#100=#4120 (expect #100=5)
#101=#5001 (expect #101=1)
M30
(finally records: tool 5)
