O1 (NUL-11: an offset is never vacant)
#5221=7.
#5221=#0
#100=#5221 (expect #100=0)
M30
