# One Liberty library of several files that follow each other: the header of the first, then the tables' templates and the cells
# of all. Left out: default wire loads, and cells whose names match `avoid`. An error if the cell `driver` is no inverter. Written by
# dualsplit, do not edit; run by `make timing`.
BEGIN { file = 1 }
/^\/\* end of file \*\/$/ { file++; depth = 0; next }
/default_wire_load/ { next }
{
    line = $0
    change = gsub(/{/, "{", line) - gsub(/}/, "}", line)
    if (depth == 0) keep = file == 1
    if (depth == 1) {
        if (line ~ /^[ \t]*cell *\(/) {
            name = line
            gsub(/^[ \t]*cell *\( *"?|"? *\).*/, "", name)
            keep = avoid == "" || name !~ avoid
        } else keep = change >= 0 && (file == 1 || line ~ /template *\(/)
    }
    if (keep && name == driver && match(line, /[ \t]function *:.*/)) {
        value = substr(line, RSTART, RLENGTH)
        gsub(/.*:|[ \t();"]/, "", value)
        inverts = value ~ /^(![A-Za-z0-9_]+|[A-Za-z0-9_]+')$/
    }
    if (keep) print
    depth += change
}
END {
    print "}"
    if (!inverts) {
        print "DRIVER has to name an inverter of LIBERTY, and " driver " is none" > "/dev/stderr"
        exit 1
    }
}
