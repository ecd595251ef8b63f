O1 (section 7.4: L10 L11 for H, L12 L13 for D)
G10 L10 P1 R50.
G10 L11 P1 R0.5
G10 L12 P1 R5.
G10 L13 P1 R0.1
#100=#11001 (expect #100=50)
#101=#10001 (expect #101=0.5)
#102=#13001 (expect #102=5)
#103=#12001 (expect #103=0.1)
M30
