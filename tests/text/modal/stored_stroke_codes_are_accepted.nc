O1 (group 04: G22 and G23)
G23
#100=#4004 (expect #100=23)
G22
#101=#4004 (expect #101=22)
M30
