(run with: --machine mill4)
O1 (section 3.3: A is axis 4)
G90 G00 A30.
#100=#5004 (expect #100=30)
#101=#5024 (expect #101=30)
M30
