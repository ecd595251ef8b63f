let pulse=1 ' (expect alarm LB0005 at pulse)
