O1 (NUL-2: minus, functions, MOD and bit operators)
#100=-#1 (expect #100=0)
#101=SIN[#1] (expect #101=0)
#102=COS[#1] (expect #102=1)
#103=#1MOD5 (expect #103=0)
#104=#1OR6 (expect #104=6)
#105=#1AND6 (expect #105=0)
#106=#1XOR6 (expect #106=6)
M30
