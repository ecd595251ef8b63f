x=1
ä=2 ' (expect alarm LB0026 at ä)
