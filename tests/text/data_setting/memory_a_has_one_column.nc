(run with: --param offset_memory=A)
O1 (section 7.4: L11, and L1 means the same)
G10 L11 P3 R7.
#100=#2003 (expect #100=7)
G10 L1 P4 R8.
#101=#2004 (expect #101=8)
M30
