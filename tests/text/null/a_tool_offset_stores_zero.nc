O1 (NUL-11: an offset is never vacant)
#11003=7.
#11003=#0
#100=#11003 (expect #100=0)
M30
